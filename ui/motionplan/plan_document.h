#pragma once

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "core/motionplan/plan.h"

namespace kickstand::ui {

/// The plan that a person works on, with every change undoable. GUI thread.
class PlanDocument final : public QObject {
    Q_OBJECT
  public:
    using Movements = std::vector<motionplan::Movement>;

    explicit PlanDocument(QObject* parent = nullptr);

    const Movements& movements() const { return movements_; }
    QUndoStack& undoStack() { return undo_; }

    /// Puts them before the step of that place; at the end for a place past it.
    void insert(std::size_t place, const Movements& movements);
    void replace(std::size_t place, const Movements& movements);
    void remove(std::size_t place);
    /// The step comes to stand at the place that `to` is now.
    void move(std::size_t from, std::size_t to);
    void setAll(const Movements& movements);

  signals:
    void changed();

  private:
    class Change;

    void become(const QString& what, Movements movements);
    void show(const Movements& movements);

    Movements movements_;
    QUndoStack undo_;
};

}  // namespace kickstand::ui
