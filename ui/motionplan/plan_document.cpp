#include "ui/motionplan/plan_document.h"

#include <QUndoCommand>
#include <algorithm>

namespace kickstand::ui {

/// From one whole plan to another: plans are short.
class PlanDocument::Change final : public QUndoCommand {
  public:
    Change(PlanDocument& document, const QString& what, Movements after)
        : QUndoCommand(what), document_(document), before_(document.movements()), after_(std::move(after)) {}

    void undo() override { document_.show(before_); }
    void redo() override { document_.show(after_); }

  private:
    PlanDocument& document_;
    Movements before_;
    Movements after_;
};

namespace {

auto at(PlanDocument::Movements& movements, std::size_t place) {
    return movements.begin() + static_cast<std::ptrdiff_t>(std::min(place, movements.size()));
}

}  // namespace

PlanDocument::PlanDocument(QObject* parent) : QObject(parent) {}

void PlanDocument::become(const QString& what, Movements movements) {
    if (movements == movements_) return;
    undo_.push(new Change(*this, what, std::move(movements)));
}

void PlanDocument::show(const Movements& movements) {
    movements_ = movements;
    emit changed();
}

void PlanDocument::insert(std::size_t place, const Movements& movements) {
    Movements after = movements_;
    after.insert(at(after, place), movements.begin(), movements.end());
    become(tr("add"), std::move(after));
}

void PlanDocument::replace(std::size_t place, const Movements& movements) {
    if (place >= movements_.size()) return;
    Movements after = movements_;
    after.erase(at(after, place));
    after.insert(at(after, place), movements.begin(), movements.end());
    become(tr("change"), std::move(after));
}

void PlanDocument::remove(std::size_t place) {
    if (place >= movements_.size()) return;
    Movements after = movements_;
    after.erase(at(after, place));
    become(tr("remove"), std::move(after));
}

void PlanDocument::move(std::size_t from, std::size_t to) {
    if (from >= movements_.size() || to >= movements_.size()) return;
    Movements after = movements_;
    const motionplan::Movement moved = after[from];
    after.erase(at(after, from));
    after.insert(at(after, to), moved);
    become(tr("move"), std::move(after));
}

void PlanDocument::setAll(const Movements& movements) {
    become(tr("open"), movements);
}

}  // namespace kickstand::ui
