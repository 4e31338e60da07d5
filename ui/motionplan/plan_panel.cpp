#include "ui/motionplan/plan_panel.h"

#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStyledItemDelegate>
#include <QTimer>
#include <algorithm>

#include "core/base/hex.h"
#include "core/engine/describe.h"
#include "core/engine/describe_motionplan.h"
#include "core/motionplan/wire/plan_text.h"
#include "ui/motionplan/motionplan_view.h"
#include "ui/motionplan/plan_document.h"
#include "ui/motionplan/plan_path.h"
#include "ui/motionplan/plan_step_row.h"
#include "ui/shell/bench.h"
#include "ui/widgets/open_file.h"
#include "ui/widgets/save_file.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using motionplan::Movement;
using motionplan::Wheels;

namespace {

constexpr Movement kZeroByte{Wheels::BothForward, 1000};
constexpr int kMostTrack_cm = 50;
constexpr int kRedraw_ms = 100;
// How fast a robot is thought to be while its next status is waited for.
constexpr double kSpeed_cm_per_s = 20;
constexpr double kTurn_deg_per_s = 60;

constexpr int kExecutesRole = Qt::UserRole + 1;

/// Marks the row of the step that executes, in the colours of whatever theme there is when it is drawn.
class StepDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (!index.data(kExecutesRole).toBool()) return;
        option->font.setBold(true);
        option->backgroundBrush = tokensOf(option->palette).accentSoft;
    }
};

QPushButton* button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
    auto* made = new QPushButton(text, parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setToolTip(tip);
    made->setAutoDefault(false);
    return made;
}

QLabel* line(const char* name, QWidget* parent) {
    auto* made = new QLabel(parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setWordWrap(true);
    made->setTextFormat(Qt::PlainText);
    made->setFont(textFont(metrics::kSmallTextSize));
    return made;
}

/// "3   turn left 84°   9c", with what is to be known of it.
QString stepText(std::size_t place, const Movement& movement, bool executes = false) {
    const auto byte = motionplan::wire::encodeMovement(movement);
    QString text = QStringLiteral("%1   %2").arg(place + 1).arg(movementText(movement));
    if (!byte)
        return text + PlanPanel::tr("   no code: %1")
                          .arg(QString::fromStdString(motionplan::alternativeTo(movement)));
    const std::uint8_t raw = *byte;
    text += QStringLiteral("   ") + QString::fromStdString(toHex({&raw, 1}));
    if (raw == 0) text += PlanPanel::tr("   zero byte");
    if (executes) text += PlanPanel::tr("   \u25b6 executing");
    return text;
}

}  // namespace

PlanPanel::PlanPanel(Bench& bench, PlanDocument& document, QWidget* parent)
    : Panel(bench, parent),
      document_(document),
      steps_(new QListWidget(this)),
      row_(new PlanStepRow(this)),
      path_(new PlanPath(this)),
      header_(line("planHeader", this)),
      length_(line("planLength", this)),
      notice_(line("planNotice", this)),
      elsewhere_(line("planElsewhere", this)),
      track_(new QSpinBox(this)),
      duplicate_(
          button("planDuplicate", tr("Duplicate"), tr("The chosen step once more, after itself"), this)),
      remove_(button("planRemove", tr("Remove"), tr("The chosen step"), this)),
      up_(button("planUp", tr("Up"), tr("The chosen step one place up; steps can be dragged too"), this)),
      down_(button("planDown", tr("Down"), tr("The chosen step one place down"), this)),
      split_(
          button("planSplit", tr("Split 1000 cm"),
                 tr("Forward 1000 cm is a zero byte, which a robot's program may take for the end: 900 and "
                    "100 cm in its place"),
                 this)),
      undo_(button("planUndo", tr("Undo"), tr("The last change"), this)),
      redo_(button("planRedo", tr("Redo"), tr("What was undone"), this)),
      open_(button("planOpen", tr("Open\u2026"), tr("A plan from a file"), this)),
      save_(button("planSave", tr("Save\u2026"), tr("The plan as text"), this)) {
    build();
    connectDocument();
    connectButtons();
    connectKeys();
    refreshSteps();
    refreshState();
}

void PlanPanel::build() {
    steps_->setObjectName(QStringLiteral("planSteps"));
    steps_->setAccessibleName(tr("Steps of the plan"));
    steps_->setItemDelegate(new StepDelegate(steps_));
    steps_->setDragDropMode(QAbstractItemView::InternalMove);
    steps_->setFont(numberFont(metrics::kTextSize));
    steps_->setMinimumWidth(240);
    header_->setText(
        tr("Before the steps Create sends 00, the plan's ID and the slot's number. Its 00 is a zero byte, "
           "and so "
           "is slot 0."));
    header_->setToolTip(
        tr("A robot whose program reads its mailbox as text loses what follows a zero byte."));
    track_->setObjectName(QStringLiteral("planTrack"));
    track_->setAccessibleName(tr("Distance between the wheels, for drawing"));
    track_->setRange(1, kMostTrack_cm);
    track_->setValue(static_cast<int>(motionplan::kTrackWidth_cm));
    track_->setPrefix(tr("track "));
    track_->setSuffix(tr(" cm"));
    auto* left = new QVBoxLayout;
    left->setSpacing(metrics::kGap);
    left->addWidget(row_);
    left->addWidget(steps_, 1);
    left->addWidget(header_);
    left->addWidget(length_);
    left->addWidget(notice_);
    auto* right = new QVBoxLayout;
    right->setSpacing(metrics::kGap);
    right->addWidget(path_, 1);
    auto* under = new QHBoxLayout;
    under->addWidget(elsewhere_, 1);
    under->addWidget(track_, 0, Qt::AlignTop);
    right->addLayout(under);
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    columns->setSpacing(metrics::kPadding);
    columns->addLayout(left, 3);
    columns->addWidget(makeButtons());
    columns->addLayout(right, 4);
}

QWidget* PlanPanel::makeButtons() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    for (QPushButton* one : {duplicate_, remove_, up_, down_, split_, undo_, redo_, open_, save_})
        column->addWidget(one);
    column->addStretch(1);
    return box;
}

void PlanPanel::connectDocument() {
    connect(&document_, &PlanDocument::changed, this, &PlanPanel::refreshSteps);
    connect(&bench(), &Bench::changed, this, &PlanPanel::refreshState);
    connect(steps_, &QListWidget::currentRowChanged, this, [this](int row) {
        path_->setChosen(row);
        if (row >= 0) row_->setMovement(document_.movements()[static_cast<std::size_t>(row)]);
        refreshState();
    });
    // From the event loop: the list is in the middle of its own change.
    connect(
        steps_->model(), &QAbstractItemModel::rowsMoved, this, [this] { rowsMoved(); }, Qt::QueuedConnection);
    connect(row_, &PlanStepRow::added, this, [this](const std::vector<Movement>& movements) {
        const std::size_t place =
            chosen() < 0 ? document_.movements().size() : static_cast<std::size_t>(chosen()) + 1;
        document_.insert(place, movements);
        choose(static_cast<int>(place + movements.size()) - 1);
    });
    connect(row_, &PlanStepRow::changed, this, [this](const std::vector<Movement>& movements) {
        const int place = chosen();
        if (place < 0) return;
        document_.replace(static_cast<std::size_t>(place), movements);
        choose(place);
    });
    connect(track_, &QSpinBox::valueChanged, this, [this](int track_cm) { path_->setTrack(track_cm); });
    // Between two statuses the robot goes on.
    auto* redraw = new QTimer(this);
    connect(redraw, &QTimer::timeout, this, [this] {
        if (path_->executing() > 0) refreshState();
    });
    redraw->start(kRedraw_ms);
}

void PlanPanel::connectButtons() {
    const auto onChosen = [this](QPushButton* one, auto act) {
        connect(one, &QPushButton::clicked, this, [this, act] {
            if (const int place = chosen(); place >= 0) act(static_cast<std::size_t>(place));
        });
    };
    onChosen(duplicate_, [this](std::size_t place) {
        document_.insert(place + 1, {document_.movements()[place]});
        choose(static_cast<int>(place) + 1);
    });
    onChosen(remove_, [this](std::size_t place) {
        document_.remove(place);
        choose(std::min(static_cast<int>(place), steps_->count() - 1));
    });
    onChosen(up_, [this](std::size_t place) {
        if (place == 0) return;
        document_.move(place, place - 1);
        choose(static_cast<int>(place) - 1);
    });
    onChosen(down_, [this](std::size_t place) {
        if (place + 1 >= document_.movements().size()) return;
        document_.move(place, place + 1);
        choose(static_cast<int>(place) + 1);
    });
    connect(split_, &QPushButton::clicked, this, &PlanPanel::split);
    // The plan has changed before the stack knows what can be undone.
    QUndoStack& changes = document_.undoStack();
    undo_->setEnabled(changes.canUndo());
    redo_->setEnabled(changes.canRedo());
    connect(&changes, &QUndoStack::canUndoChanged, undo_, &QPushButton::setEnabled);
    connect(&changes, &QUndoStack::canRedoChanged, redo_, &QPushButton::setEnabled);
    connect(undo_, &QPushButton::clicked, &changes, &QUndoStack::undo);
    connect(redo_, &QPushButton::clicked, &changes, &QUndoStack::redo);
    connect(open_, &QPushButton::clicked, this, &PlanPanel::open);
    connect(save_, &QPushButton::clicked, this, &PlanPanel::save);
}

void PlanPanel::connectKeys() {
    const auto add = [](const QKeySequence& keys, QWidget* where, QPushButton* one) {
        auto* shortcut = new QShortcut(keys, where);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, one, &QPushButton::click);
        one->setToolTip(
            QStringLiteral("%1 (%2)").arg(one->toolTip(), keys.toString(QKeySequence::NativeText)));
    };
    add(QKeySequence::Undo, this, undo_);
    add(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), this, redo_);
    add(QKeySequence::Delete, steps_, remove_);
}

int PlanPanel::chosen() const {
    return steps_->currentRow();
}

void PlanPanel::choose(int row) {
    steps_->setCurrentRow(row);
}

void PlanPanel::rowsMoved() {
    PlanDocument::Movements after;
    for (int row = 0; row < steps_->count(); ++row) {
        const auto place = static_cast<std::size_t>(steps_->item(row)->data(Qt::UserRole).toInt());
        if (place < document_.movements().size()) after.push_back(document_.movements()[place]);
    }
    if (after.size() != document_.movements().size()) return;
    const int row = chosen();
    document_.setAll(after);
    choose(row);
}

void PlanPanel::split() {
    PlanDocument::Movements after;
    for (const Movement& movement : document_.movements()) {
        if (movement == kZeroByte) {
            after.push_back({Wheels::BothForward, 900});
            after.push_back({Wheels::BothForward, 100});
        } else {
            after.push_back(movement);
        }
    }
    document_.setAll(after);
}

void PlanPanel::refreshSteps() {
    const PlanDocument::Movements& movements = document_.movements();
    const int row = chosen();
    {
        const QSignalBlocker quiet(steps_);
        steps_->clear();
        for (std::size_t i = 0; i < movements.size(); ++i) {
            auto* item = new QListWidgetItem(stepText(i, movements[i]), steps_);
            item->setData(Qt::UserRole, static_cast<int>(i));
            // Dropped between two steps, never onto one: that would take its place.
            item->setFlags(item->flags() & ~Qt::ItemIsDropEnabled);
        }
        steps_->setCurrentRow(std::min(row, steps_->count() - 1));
    }
    path_->setPlan(movements);
    path_->setChosen(chosen());
    constexpr int kHeader = 3;
    constexpr int kTerminator = 1;
    const auto count = static_cast<int>(movements.size());
    length_->setText(tr("%1 of %2 movements, %3 of 59 bytes with header and end")
                         .arg(count)
                         .arg(motionplan::wire::kMostMovements)
                         .arg(count + kHeader + kTerminator));
    const auto bytes = motionplan::planBytes(movements, motionplan::PlanUse::Slot);
    const auto zeros = std::count(movements.begin(), movements.end(), kZeroByte);
    if (movements.empty())
        notice_->setText(tr("No steps yet. Add one above, or open a file."));
    else if (!bytes)
        notice_->setText(describe(bytes.error()).line());
    else if (zeros > 0)
        notice_->setText(tr("Zero bytes: %1. A robot whose program reads its mailbox as text loses what "
                            "follows; Split 1000 cm avoids it.")
                             .arg(zeros));
    else
        notice_->setText({});
    refreshState();
}

double PlanPanel::doneOf(const motionplan::Execution& execution, TimePoint now) const {
    const auto step = static_cast<std::size_t>(execution.step - 1);
    if (execution.step < 1 || step >= document_.movements().size()) return 0;
    const Movement& movement = document_.movements()[step];
    const double speed = motionplan::wire::isTurn(movement.wheels) ? kTurn_deg_per_s : kSpeed_cm_per_s;
    return std::clamp(seconds(now - execution.stepAt) * speed / movement.amount, 0.0, 1.0);
}

void PlanPanel::refreshState() {
    const bool any = chosen() >= 0;
    for (QPushButton* one : {duplicate_, remove_, up_, down_})
        one->setEnabled(any);
    row_->setCanChange(any);
    const PlanDocument::Movements& movements = document_.movements();
    split_->setEnabled(std::find(movements.begin(), movements.end(), kZeroByte) != movements.end());
    save_->setEnabled(!movements.empty());
    const motionplan::Snapshot* const snapshot = planSnapshotOf(bench().session());
    const auto bytes = motionplan::planBytes(movements, motionplan::PlanUse::Trigger);
    // Only what is drawn here may be shown to move here.
    const bool runs = snapshot != nullptr && snapshot->execution.state == motionplan::Execution::State::Runs;
    const bool own = runs && bytes && snapshot->execution.movements == *bytes;
    const int step = own ? snapshot->execution.step : 0;
    markExecuting(step);
    elsewhere_->setText(runs && !own ? elsewhereText(snapshot->execution) : QString());
    path_->setExecuting(step, own ? doneOf(snapshot->execution, bench().client().now()) : 0);
    setNote(step > 0 ? tr("step %1 of %2").arg(step).arg(movements.size())
                     : tr("%n step(s)", nullptr, static_cast<int>(movements.size())));
}

void PlanPanel::markExecuting(int step) {
    const PlanDocument::Movements& movements = document_.movements();
    for (std::size_t i = 0; i < movements.size(); ++i) {
        QListWidgetItem* const item = steps_->item(static_cast<int>(i));
        // A step that is being dragged is in the list's hands.
        if (item == nullptr) return;
        const bool executes = static_cast<int>(i) + 1 == step;
        item->setData(kExecutesRole, executes);
        item->setText(stepText(i, movements[i], executes));
        if (executes && step != path_->executing()) steps_->scrollToItem(item);
    }
}

QString PlanPanel::elsewhereText(const motionplan::Execution& execution) const {
    if (execution.movements.empty())
        return tr("Plan %1 executes and is not drawn: it was not sent over this connection, and the robot "
                  "names plans by their ID alone.")
            .arg(execution.plan);
    return tr("Plan %1 executes and is not drawn: it is another one than the plan here.").arg(execution.plan);
}

void PlanPanel::open() {
    askToOpen(this, tr("Open a plan"), {tr("Plans (*.plan *.txt)"), tr("All files (*)")},
              [this](const QStringList& paths) {
                  QFile file(paths.value(0));
                  const QString name = QFileInfo(file).fileName();
                  if (!file.open(QIODevice::ReadOnly)) {
                      notice_->setText(tr("%1 cannot be read: %2").arg(name, file.errorString()));
                      return;
                  }
                  const auto read = motionplan::wire::parsePlanText(
                      file.read(motionplan::wire::kMostPlanTextBytes + 1).toStdString());
                  if (read && read->empty())
                      notice_->setText(tr("%1 holds no movement; the plan here stays as it is.").arg(name));
                  else if (!read)
                      notice_->setText(tr("%1 is not a plan. %2").arg(name, describe(read.error()).line()));
                  else
                      document_.setAll(*read);
              });
}

void PlanPanel::save() {
    askToSave(this, tr("Save the plan"), tr("robot.plan"), QStringLiteral("plan"), [this] {
        QByteArray text;
        for (const Movement& movement : document_.movements())
            text += QByteArray::fromStdString(motionplan::wire::toText(movement)) + '\n';
        return text;
    });
}

}  // namespace kickstand::ui
