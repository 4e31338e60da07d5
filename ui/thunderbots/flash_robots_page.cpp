#include "ui/thunderbots/flash_robots_page.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/thunderbots/flash_words.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kRowHeight = 24;
constexpr int kTickWidth = 84;
constexpr int kVoltsWidth = 76;

RobotMask heardIn(const Snapshot* snapshot) {
    RobotMask heard = 0;
    for (int robot = 0; snapshot != nullptr && robot < kRobots; ++robot) {
        if (snapshot->robots[static_cast<std::size_t>(robot)].live) heard |= maskOf(robot);
    }
    return heard;
}

/// How a row looks whose robot has no obstacle left.
std::pair<Tone, QString> readyState(const RobotState& robot) {
    if (isFlashBatteryLow(robot))
        return {Tone::Warning, FlashRobotsPage::tr("battery too low: advised against")};
    if (isFlashCapacitorUnknown(robot))
        return {Tone::Warning, FlashRobotsPage::tr("capacitor not measured: treat as live")};
    if (robot.freshness != Freshness::Current)
        return {Tone::Idle, FlashRobotsPage::tr("ready; it measures nothing")};
    return {Tone::Good, FlashRobotsPage::tr("ready")};
}

Tone toneOf(FlashObstacle obstacle) {
    if (obstacle == FlashObstacle::CapacitorLive || obstacle == FlashObstacle::CapacitorUnknown)
        return Tone::Danger;
    return obstacle == FlashObstacle::Asked || obstacle == FlashObstacle::Discharging ? Tone::Busy
                                                                                      : Tone::Warning;
}

}  // namespace

FlashRobotsPage::FlashRobotsPage(QWidget* parent) : FlashPageView(parent) {
    makeHead();
    empty_ = makeText("flashNoRobot", content());
    empty_->setForegroundRole(QPalette::PlaceholderText);
    column()->addWidget(empty_);
    for (int robot = 0; robot < kRobots; ++robot)
        rows_[static_cast<std::size_t>(robot)] = makeRow(robot);
    column()->addStretch(1);
    makeOptions();
}

void FlashRobotsPage::makeHead() {
    auto* row = new QHBoxLayout;
    auto* words = makeText("flashRobotsWords", this);
    words->setText(tr("Which robots? On their stands, with good batteries, and near the dongle."));
    everyone_ = makeButton("flashEveryone", tr("All that are heard"), this);
    row->addWidget(words, 1);
    row->addWidget(everyone_);
    head()->addLayout(row);
    connect(everyone_, &QPushButton::clicked, this, [this] { emit robotsAsked(heard_); });
}

FlashRobotsPage::Row FlashRobotsPage::makeRow(int robot) {
    Row row;
    row.all = new QWidget(content());
    auto* line = new QHBoxLayout(row.all);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(metrics::kGap);
    row.tick = new QCheckBox(tr("Robot %1").arg(robot), row.all);
    row.tick->setObjectName(QStringLiteral("flashRobot%1").arg(robot));
    row.tick->setFixedWidth(kTickWidth);
    const auto number = [&row](const char* name, int robotNumber) {
        auto* label = new QLabel(row.all);
        label->setObjectName(QString::fromLatin1(name) + QString::number(robotNumber));
        label->setFont(numberFont(metrics::kTextSize));
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        label->setFixedWidth(kVoltsWidth);
        return label;
    };
    row.battery = number("flashBattery", robot);
    row.battery->setToolTip(tr("Battery"));
    row.capacitor = number("flashCapacitor", robot);
    row.capacitor->setToolTip(tr("Capacitor"));
    row.state = new StateLabel(row.all);
    row.state->setObjectName(QStringLiteral("flashState%1").arg(robot));
    row.remedy = makeButton("flashRemedy", {}, row.all);
    row.remedy->setObjectName(QStringLiteral("flashRemedy%1").arg(robot));
    line->addWidget(row.tick);
    line->addWidget(row.battery);
    line->addWidget(row.capacitor);
    line->addSpacing(metrics::kGap);
    line->addWidget(row.state, 1);
    line->addWidget(row.remedy);
    row.all->setMinimumHeight(kRowHeight);
    column()->addWidget(row.all);
    connect(row.tick, &QCheckBox::clicked, this, [this, robot](bool on) {
        emit robotsAsked(on ? ticked_ | maskOf(robot) : ticked_ & ~maskOf(robot));
    });
    connect(row.remedy, &QPushButton::clicked, this, [this, robot] { emit remedyAsked(robot); });
    return row;
}

void FlashRobotsPage::makeOptions() {
    lowBattery_ = new QCheckBox(tr("Upload all the same to robots whose battery is below 14 V"), this);
    lowBattery_->setObjectName(QStringLiteral("flashLowBattery"));
    lowBattery_->setToolTip(
        tr("A battery that gives out during an upload leaves its robot without data in its flash."));
    capacitorUnknown_ =
        new QCheckBox(tr("I have seen to it that the capacitors which nobody measures are empty"), this);
    capacitorUnknown_->setObjectName(QStringLiteral("flashCapacitorUnknown"));
    for (QCheckBox* box : {lowBattery_, capacitorUnknown_}) {
        foot()->addWidget(box);
        connect(box, &QCheckBox::clicked, this, [this] {
            options_.lowBattery = lowBattery_->isChecked();
            options_.capacitorUnknown = capacitorUnknown_->isChecked();
            emit optionsAsked(options_);
        });
    }
}

void FlashRobotsPage::showState(const FlashWizardState& state, const Snapshot* snapshot) {
    ticked_ = state.robots;
    heard_ = heardIn(snapshot);
    everyone_->setEnabled(heard_ != 0);
    empty_->setVisible((heard_ | ticked_) == 0);
    empty_->setText(snapshot == nullptr ? tr("Not connected: choose something from Connect.")
                                        : tr("No robot is heard yet. Switch one on."));
    static const Snapshot nothing;
    for (int robot = 0; robot < kRobots; ++robot)
        showRow(robot, state, snapshot == nullptr ? nothing : *snapshot);
    showOptions(state, snapshot);
    if (snapshot != nullptr) revealHeld(state, *snapshot);
}

void FlashRobotsPage::showRow(int robot, const FlashWizardState& state, const Snapshot& snapshot) {
    const Row& row = rows_[static_cast<std::size_t>(robot)];
    const RobotState& known = snapshot.robots[static_cast<std::size_t>(robot)];
    const bool ticked = contains(ticked_, robot);
    row.all->setVisible(known.live || ticked);
    row.tick->setChecked(ticked);
    showVolts(robot, known);
    const FlashObstacle obstacle = obstacleOf(snapshot, robot, state.options);
    if (obstacle == FlashObstacle::None) {
        const auto [tone, text] = readyState(known);
        row.state->setState(tone, text);
    } else {
        // What keeps a robot back that nobody has ticked is no warning.
        row.state->setState(ticked ? toneOf(obstacle) : Tone::Idle, obstacleText(obstacle, snapshot, robot));
    }
    const QString remedy = remedyText(obstacle);
    row.remedy->setText(remedy);
    row.remedy->setVisible(!remedy.isEmpty() && ticked);
    row.remedy->setAccessibleName(tr("Robot %1: %2").arg(robot).arg(remedy));
}

void FlashRobotsPage::showVolts(int robot, const RobotState& known) {
    const Row& row = rows_[static_cast<std::size_t>(robot)];
    const bool current = known.freshness == Freshness::Current;
    row.battery->setText(current ? batteryText(known.readings.battery_V) : tr("\u2014"));
    const QString volts = current           ? capacitorText(known.readings.capacitor_V)
                          : known.capacitor ? tr("%1?").arg(capacitorText(known.capacitor->last_V))
                                            : tr("\u2014");
    // Live, whatever its age.
    const bool live = isLive(known);
    loud_ = static_cast<RobotMask>(live ? loud_ | maskOf(robot) : loud_ & ~maskOf(robot));
    setLoud(*row.capacitor, live);
    row.capacitor->setText(live ? tr("%1 live").arg(volts) : volts);
}

void FlashRobotsPage::setLoud(QLabel& label, bool loud) {
    const QColor wanted = loud ? tokensOf(palette()).danger : tokensOf(palette()).text;
    if (label.palette().color(QPalette::WindowText) == wanted) return;
    QPalette changed = label.palette();
    changed.setColor(QPalette::WindowText, wanted);
    label.setPalette(changed);
    label.setFont(numberFont(metrics::kTextSize, loud ? QFont::DemiBold : QFont::Normal));
}

void FlashRobotsPage::changeEvent(QEvent* event) {
    FlashPageView::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    for (int robot = 0; robot < kRobots; ++robot) {
        QLabel* capacitor = rows_[static_cast<std::size_t>(robot)].capacitor;
        if (capacitor != nullptr) setLoud(*capacitor, contains(loud_, robot));
    }
}

void FlashRobotsPage::revealHeld(const FlashWizardState& state, const Snapshot& snapshot) {
    int held = -1;
    for (int robot = kRobots - 1; robot >= 0; --robot) {
        const bool holds = obstacleOf(snapshot, robot, state.options) != FlashObstacle::None;
        if (contains(ticked_, robot) && holds) held = robot;
    }
    if (held == revealed_) return;
    revealed_ = held;
    if (held >= 0) reveal(rows_[static_cast<std::size_t>(held)].all);
}

void FlashRobotsPage::showOptions(const FlashWizardState& state, const Snapshot* snapshot) {
    options_ = state.options;
    bool low = false;
    bool unknown = false;
    for (int robot = 0; snapshot != nullptr && robot < kRobots; ++robot) {
        if (!contains(ticked_, robot)) continue;
        const RobotState& known = snapshot->robots[static_cast<std::size_t>(robot)];
        low = low || isFlashBatteryLow(known);
        unknown = unknown || (known.live && isFlashCapacitorUnknown(known));
    }
    lowBattery_->setVisible(low || options_.lowBattery);
    lowBattery_->setChecked(options_.lowBattery);
    capacitorUnknown_->setVisible(unknown || options_.capacitorUnknown);
    capacitorUnknown_->setChecked(options_.capacitorUnknown);
}

}  // namespace kickstand::ui
