#include "ui/motionplan/plan_robot_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <utility>

#include "core/base/hex.h"
#include "core/engine/describe.h"
#include "core/engine/describe_motionplan.h"
#include "core/motionplan/wire/nxt_status.h"
#include "ui/motionplan/motionplan_view.h"
#include "ui/motionplan/plan_document.h"
#include "ui/shell/bench.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using motionplan::Execution;
using motionplan::Snapshot;
using motionplan::Wheels;
namespace wire = motionplan::wire;

namespace {

constexpr int kStateSize = 20;
constexpr int kChangeStep_percent = 10;
constexpr int kFirstChange_percent = -30;

QLabel* label(const char* name, int size, QWidget* parent) {
    auto* made = new QLabel(parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setFont(textFont(size));
    made->setWordWrap(true);
    made->setTextFormat(Qt::PlainText);
    return made;
}

QPushButton* button(const QString& name, const QString& text, const QString& accessible, QWidget* parent) {
    auto* made = new QPushButton(text, parent);
    made->setObjectName(name);
    made->setAccessibleName(accessible);
    made->setToolTip(accessible);
    made->setAutoDefault(false);
    return made;
}

QString keptText(const std::vector<std::uint8_t>& movements) {
    QStringList parts;
    for (const motionplan::Movement& movement : motionplan::movementsOf(movements))
        parts << movementText(movement);
    return parts.join(QStringLiteral(", "));
}

/// The movement that executes, where it is known.
QString stepText(const Execution& execution) {
    const std::vector<motionplan::Movement> movements = motionplan::movementsOf(execution.movements);
    const auto step = static_cast<std::size_t>(execution.step);
    return step < 1 || step > movements.size() ? QString() : movementText(movements[step - 1]);
}

/// ": 00 01 00 0d; zero bytes: 0, 2": what would be sent. Empty for what makes no message.
QString bytesText(bool update, int plan, int slot, const std::vector<motionplan::Movement>& movements) {
    const auto sent = motionplan::sentPlan(update, plan, slot, movements);
    if (!sent) return {};
    const QString hex = QString::fromStdString(toHex(sent->bytes));
    if (sent->zeros.empty()) return PlanRobotPanel::tr(": %1").arg(hex);
    QStringList zeros;
    for (const std::size_t place : sent->zeros)
        zeros << QString::number(place);
    return PlanRobotPanel::tr(": %1; zero bytes, counted from 0: %2")
        .arg(hex, zeros.join(QStringLiteral(", ")));
}

}  // namespace

PlanRobotPanel::PlanRobotPanel(Bench& bench, PlanDocument& document, QWidget* parent)
    : Panel(bench, parent),
      document_(document),
      state_(label("planState", kStateSize, this)),
      progress_(label("planProgress", metrics::kTextSize, this)),
      warning_(label("planWarning", metrics::kTextSize, this)),
      stop_(button(QStringLiteral("planStop"), tr("Stop plan"), tr("Stops the plan that executes"), this)),
      query_(button(QStringLiteral("planQuery"), tr("Query slots"), tr("Asks what is in each slot"), this)),
      id_(new QSpinBox(this)),
      trigger_(label("planTrigger", metrics::kSmallTextSize, this)),
      setTrigger_(button(QStringLiteral("planSetTrigger"), tr("Set"),
                         tr("Makes the plan of the editor the trigger plan"), this)),
      readTrigger_(
          button(QStringLiteral("planReadTrigger"), tr("Read"), tr("Asks for the trigger plan"), this)),
      wheels_(new QComboBox(this)),
      change_(new SignedSpinBox(this)),
      adjust_(button(QStringLiteral("planAdjust"), tr("Adjust"),
                     tr("Changes the speed of these wheels while the plan executes"), this)),
      notice_(label("planRobotNotice", metrics::kSmallTextSize, this)) {
    build();
    connectButtons();
    connect(&bench, &Bench::changed, this, &PlanRobotPanel::refresh);
    connect(&document_, &PlanDocument::changed, this, &PlanRobotPanel::refresh);
    refresh();
}

void PlanRobotPanel::build() {
    id_->setObjectName(QStringLiteral("planId"));
    id_->setAccessibleName(tr("ID under which the plan is sent to an empty slot"));
    id_->setRange(wire::kFirstPlan, wire::kLastPlan);
    id_->setPrefix(tr("plan ID "));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    column->setSpacing(metrics::kGap);
    column->addWidget(state_);
    column->addWidget(progress_);
    column->addWidget(warning_);
    auto* top = new QHBoxLayout;
    top->addWidget(stop_);
    top->addWidget(query_);
    top->addStretch(1);
    column->addLayout(top);
    column->addWidget(id_);
    column->addWidget(makeSlots());
    column->addWidget(makeTrigger());
    column->addWidget(makeSpeed());
    column->addWidget(notice_);
    column->addStretch(1);
}

QWidget* PlanRobotPanel::makeSlots() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    for (int slot = 0; slot < wire::kSlots; ++slot) {
        SlotRow& row = rows_[static_cast<std::size_t>(slot)];
        row.text = label("", metrics::kTextSize, box);
        row.text->setObjectName(QStringLiteral("planSlot%1").arg(slot));
        row.send = button(QStringLiteral("planSend%1").arg(slot), tr("Create"),
                          tr("Sends the plan of the editor to slot %1").arg(slot), box);
        row.execute = button(QStringLiteral("planExecute%1").arg(slot), tr("Execute"),
                             tr("Executes the plan of slot %1").arg(slot), box);
        grid->addWidget(row.text, slot, 0);
        grid->addWidget(row.send, slot, 1);
        grid->addWidget(row.execute, slot, 2);
    }
    grid->setColumnStretch(0, 1);
    return box;
}

QWidget* PlanRobotPanel::makeTrigger() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(trigger_, 1);
    row->addWidget(setTrigger_);
    row->addWidget(readTrigger_);
    return box;
}

QWidget* PlanRobotPanel::makeSpeed() {
    wheels_->setObjectName(QStringLiteral("planSpeedWheels"));
    wheels_->setAccessibleName(tr("Wheels whose speed is changed"));
    wheels_->addItem(tr("Both wheels"), static_cast<int>(Wheels::BothForward));
    wheels_->addItem(tr("Left wheel"), static_cast<int>(Wheels::LeftForward));
    wheels_->addItem(tr("Right wheel"), static_cast<int>(Wheels::RightForward));
    change_->setObjectName(QStringLiteral("planSpeedChange"));
    change_->setAccessibleName(tr("Change of their speed, in percent"));
    change_->setRange(-wire::kMostChange_percent, wire::kMostChange_percent);
    change_->setSingleStep(kChangeStep_percent);
    change_->setValue(kFirstChange_percent);
    change_->setSuffix(tr(" %"));
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(wheels_, 1);
    row->addWidget(change_);
    row->addWidget(adjust_);
    return box;
}

void PlanRobotPanel::connectButtons() {
    for (int slot = 0; slot < wire::kSlots; ++slot) {
        const SlotRow& row = rows_[static_cast<std::size_t>(slot)];
        connect(row.send, &QPushButton::clicked, this, [this, slot] { sendTo(slot); });
        connect(row.execute, &QPushButton::clicked, this, [this, slot] { execute(slot); });
    }
    connect(stop_, &QPushButton::clicked, this, [this] { submit(motionplan::StopPlan{}); });
    connect(query_, &QPushButton::clicked, this, &PlanRobotPanel::queryAll);
    connect(id_, &QSpinBox::valueChanged, this, &PlanRobotPanel::refresh);
    connect(readTrigger_, &QPushButton::clicked, this, [this] { submit(motionplan::ReadTrigger{}); });
    connect(setTrigger_, &QPushButton::clicked, this, [this] {
        submit(motionplan::SetTrigger{id_->value(), document_.movements()});
    });
    connect(adjust_, &QPushButton::clicked, this, [this] {
        submit(
            motionplan::AdjustSpeed{static_cast<Wheels>(wheels_->currentData().toInt()), change_->value()});
    });
}

void PlanRobotPanel::submit(const motionplan::Command& command) {
    refusal_.clear();
    const bool starts = std::holds_alternative<motionplan::ExecutePlan>(command);
    starting_ = starting_ || starts;
    bench().submit(SystemCommand{command}, this, [this, starts](const Result<void>& result) {
        if (starts) starting_ = false;
        if (!result) refusal_ = describe(result.error()).line();
        refresh();
    });
    refresh();
}

void PlanRobotPanel::queryAll() {
    for (int slot = 0; slot < wire::kSlots; ++slot)
        submit(motionplan::QuerySlot{slot});
    submit(motionplan::ReadTrigger{});
}

void PlanRobotPanel::sendTo(int slot) {
    const Snapshot* const snapshot = planSnapshotOf(bench().session());
    if (snapshot == nullptr) return;
    const int resident = snapshot->slotStates[static_cast<std::size_t>(slot)].plan;
    // A full slot takes nothing but an update of the plan that is in it.
    if (resident == wire::kNoPlan)
        submit(motionplan::CreatePlan{id_->value(), slot, document_.movements()});
    else
        submit(motionplan::UpdatePlan{resident, slot, document_.movements()});
}

void PlanRobotPanel::execute(int slot) {
    const Snapshot* const snapshot = planSnapshotOf(bench().session());
    if (snapshot == nullptr) return;
    const int resident = snapshot->slotStates[static_cast<std::size_t>(slot)].plan;
    submit(motionplan::ExecutePlan{resident == wire::kNoPlan ? id_->value() : resident, slot});
}

QString PlanRobotPanel::obstacle(const Snapshot* snapshot) const {
    if (snapshot == nullptr) return tr("Connect to an NXT, or to a simulated one.");
    if (snapshot->outOfReach) return outOfReachText();
    if (snapshot->link != motionplan::LinkState::Running) return describe(snapshot->link);
    if (snapshot->nxtStatus == wire::kStatusNoProgram)
        return tr("No program is running on the NXT: start the robot's program on it.");
    if (!snapshot->answers) return tr("The robot does not answer.");
    return {};
}

QString PlanRobotPanel::executionText(const Snapshot& snapshot) const {
    const Execution& execution = snapshot.execution;
    if (snapshot.outOfReach) return tr("Out of reach");
    if (!snapshot.active()) return tr("At rest");
    // Asked for, and no step was named yet.
    if (execution.step == 0) return tr("Plan %1").arg(execution.plan);
    QString text = tr("Plan %1, step %2").arg(execution.plan).arg(execution.step);
    if (!execution.movements.empty()) text += tr(" of %1").arg(execution.movements.size());
    return text;
}

QString PlanRobotPanel::progressText(const Snapshot& snapshot) const {
    const Execution& execution = snapshot.execution;
    if (execution.state == Execution::State::Unsure)
        return tr(
            "It may be executing: nothing that confirms it came back. Look at the robot, and press Stop plan "
            "to be sure.");
    if (!snapshot.active())
        return snapshot.request ? tr("asking the robot, %n more waiting", nullptr,
                                     static_cast<int>(snapshot.request->waiting))
                                : QString();
    QString text = describe(execution.state);
    if (const QString step = stepText(execution); !step.isEmpty()) text = tr("%1: %2").arg(text, step);
    if (execution.stale) text += tr("; nothing heard for a while");
    return text;
}

QString PlanRobotPanel::warningText(const motionplan::TriggerState& trigger) const {
    if (trigger.plan != wire::kNoPlan)
        return tr("When the connection ends, the robot starts its trigger plan; STOP cannot reach it then.");
    if (trigger.known) return tr("STOP needs Bluetooth: without it the robot goes on with its plan.");
    return tr(
        "STOP needs Bluetooth: without it the robot goes on with its plan or starts its trigger plan, and "
        "STOP cannot reach it.");
}

void PlanRobotPanel::refresh() {
    const Snapshot* const snapshot = planSnapshotOf(bench().session());
    const QString why = obstacle(snapshot);
    const bool reach = why.isEmpty();
    state_->setText(snapshot == nullptr ? tr("No robot") : executionText(*snapshot));
    progress_->setText(reach ? progressText(*snapshot) : why);
    warning_->setText(warningText(snapshot == nullptr ? motionplan::TriggerState{} : snapshot->trigger));
    // Stop needs no answer to be sent: a robot that is silent may hear all the same.
    stop_->setEnabled(snapshot != nullptr && snapshot->link == motionplan::LinkState::Running);
    query_->setEnabled(reach);
    readTrigger_->setEnabled(reach);
    setTrigger_->setEnabled(
        reach && motionplan::planBytes(document_.movements(), motionplan::PlanUse::Trigger).has_value());
    adjust_->setEnabled(reach && snapshot->execution.state == Execution::State::Runs);
    for (int slot = 0; slot < wire::kSlots; ++slot)
        refreshSlot(slot, snapshot);
    refreshTrigger(snapshot);
    if (snapshot != nullptr) dropSettledRefusal(*snapshot);
    notice_->setText(refusal_);
    const bool gone = snapshot == nullptr || snapshot->outOfReach;
    setNote(gone ? QString() : describe(snapshot->execution.state));
}

void PlanRobotPanel::dropSettledRefusal(const Snapshot& snapshot) {
    const Execution::State before = std::exchange(executed_, snapshot.execution.state);
    const bool reconnected = std::exchange(connections_, snapshot.connections) != snapshot.connections;
    const bool confirmed = std::exchange(stoppedAt_, snapshot.stopConfirmedAt) != snapshot.stopConfirmedAt;
    const bool stopped = confirmed && before != Execution::State::Idle;
    const bool sure = before == Execution::State::Unsure && executed_ != before;
    if (reconnected || stopped || sure) refusal_.clear();
}

void PlanRobotPanel::refreshSlot(int slot, const Snapshot* snapshot) {
    const SlotRow& row = rows_[static_cast<std::size_t>(slot)];
    const motionplan::SlotState state =
        snapshot == nullptr ? motionplan::SlotState{} : snapshot->slotStates[static_cast<std::size_t>(slot)];
    const bool reach = obstacle(snapshot).isEmpty();
    const bool full = state.plan != wire::kNoPlan;
    const bool runs = snapshot != nullptr && snapshot->active() && snapshot->execution.slot == slot &&
                      snapshot->execution.plan == state.plan;
    const QString held = !state.known ? tr("not asked")
                         : !full      ? tr("empty")
                         : runs ? tr("plan %1, %2").arg(state.plan).arg(describe(snapshot->execution.state))
                                : tr("plan %1").arg(state.plan);
    // The robot names plans by their ID alone.
    const bool elsewhere = full && state.movements.empty();
    const QString steps = elsewhere ? tr("\nsteps not known")
                          : full    ? tr("\n%n step(s)", nullptr, static_cast<int>(state.movements.size()))
                                    : QString();
    row.text->setText(tr("%1: %2").arg(slot).arg(held) + steps);
    row.text->setToolTip(elsewhere ? tr("It was not sent over this connection, and the robot names plans by "
                                        "their ID alone.")
                                   : keptText(state.movements));
    row.send->setText(full ? tr("Update") : tr("Create"));
    row.send->setToolTip(tr("Sends the plan of the editor to slot %1").arg(slot) +
                         bytesText(full, full ? state.plan : id_->value(), slot, document_.movements()));
    row.send->setEnabled(reach &&
                         motionplan::planBytes(document_.movements(), motionplan::PlanUse::Slot).has_value());
    row.execute->setEnabled(reach && (full || !state.known) && !snapshot->active() && !starting_);
}

void PlanRobotPanel::refreshTrigger(const Snapshot* snapshot) {
    const motionplan::TriggerState state =
        snapshot == nullptr ? motionplan::TriggerState{} : snapshot->trigger;
    const bool any = state.plan != wire::kNoPlan;
    const QString held = !state.known ? (any ? tr("plan %1, not confirmed").arg(state.plan) : tr("not known"))
                         : any        ? tr("plan %1").arg(state.plan)
                                      : tr("none");
    trigger_->setText(tr("Trigger plan: %1").arg(held));
    trigger_->setToolTip(keptText(state.movements));
}

}  // namespace kickstand::ui
