#include "ui/thunderbots/drive_panel.h"

#include <QFrame>
#include <QLabel>
#include <QResizeEvent>
#include <QSettings>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/high_voltage_box.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/wheels_box.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

using namespace std::chrono_literals;

constexpr const char* kReleaseSetting = "drive/releaseToZero";
/// From here on the two boxes stand side by side.
constexpr int kWideEnough = 620;
constexpr int kVoltageWidth = 260;
constexpr int kBoxGap = 20;
/// A mouse may speak a thousand times a second: no faster than this.
constexpr auto kPace = 8ms;
/// A snapshot follows an answer within this, if anything changed at all.
constexpr auto kSnapshotLag = 100ms;

}  // namespace

DrivePanel::DrivePanel(Bench& bench, RobotChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      boxes_(new QBoxLayout(QBoxLayout::LeftToRight)),
      wheels_(new WheelsBox(this)),
      voltage_(new HighVoltageBox(this)),
      told_(new QLabel(this)),
      notice_(new QLabel(this)) {
    told_->setObjectName(QStringLiteral("told"));
    told_->setFont(numberFont(metrics::kTextSize));
    notice_->setObjectName(QStringLiteral("notice"));
    notice_->setWordWrap(true);
    notice_->setMinimumHeight(20);
    boxes_->setSpacing(kBoxGap);
    boxes_->addWidget(wheels_, 1);
    boxes_->addWidget(voltage_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, 10, metrics::kPadding, metrics::kGap);
    column->setSpacing(metrics::kGap);
    column->addLayout(boxes_);
    column->addSpacing(4);
    column->addWidget(told_);
    column->addWidget(notice_);
    column->addStretch(1);

    pace_.setSingleShot(true);
    pace_.setTimerType(Qt::PreciseTimer);
    wheels_->setReleaseToZero(bench.settings().value(kReleaseSetting, true).toBool());
    connectBoxes();
    refresh();
}

void DrivePanel::connectBoxes() {
    connect(wheels_, &WheelsBox::wheelAsked, this, &DrivePanel::askWheel);
    connect(wheels_, &WheelsBox::zeroAsked, this, &DrivePanel::askZero);
    connect(wheels_, &WheelsBox::runAsked, this, [this] {
        held_ = false;
        sendWheels();
    });
    connect(wheels_, &WheelsBox::brakeAsked, this, [this] {
        wheels_->reset();
        late_ = false;
        ask(Brake{summary_.live});
    });
    connect(wheels_, &WheelsBox::dribblerAsked, this, [this](bool on) {
        ask(SetDribbler{summary_.live, on});
    });
    connect(wheels_, &WheelsBox::limitAsked, this, [this](int limit) { ask(SetWheelLimit{limit}); });
    connect(wheels_, &WheelsBox::releaseToZeroChanged, this,
            [this](bool on) { bench().settings().setValue(kReleaseSetting, on); });
    connect(voltage_, &HighVoltageBox::armAsked, this, [this](bool on) {
        ask(ArmHighVoltage{summary_.live, on});
    });
    connect(voltage_, &HighVoltageBox::chargerAsked, this, [this](bool on) {
        ask(SetCharger{summary_.live, on});
    });
    connect(voltage_, &HighVoltageBox::dischargeAsked, this, [this](bool on) {
        for (int robot = 0; robot < kRobots; ++robot) {
            if (contains(summary_.live, robot)) ask(Discharge{robot, on});
        }
    });
    connect(&pace_, &QTimer::timeout, this, &DrivePanel::sendLate);
    // The age of a lost capacitor goes on while nothing else happens.
    connect(&ages_, &QTimer::timeout, this, &DrivePanel::refresh);
    ages_.start(1s);
    connect(new QShortcut(QKeySequence(Qt::Key_Z), this), &QShortcut::activated, this, &DrivePanel::askZero);
    connect(&choice_, &RobotChoice::changed, this, [this] {
        // What was set for others is not meant for these.
        reset();
        refresh();
    });
    connect(&bench(), &Bench::changed, this, &DrivePanel::refresh);
    connect(&bench().client(), &EngineClient::stopChanged, this, [this] {
        reset();
        // The snapshot at hand is of before.
        answeredAt_ = bench().client().now();
        refresh();
    });
}

void DrivePanel::reset() {
    late_ = false;
    wheels_->reset();
    passedZero_ = 0;
    refusal_.clear();
}

void DrivePanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    static const Snapshot nothing;
    const Snapshot& shown = snapshot == nullptr ? nothing : *snapshot;
    if (connections_ != shown.connections) {
        connections_ = shown.connections;
        reset();
    }
    summary_ = summarize(shown, choice_.chosen());
    if (!summary_.mustPassZero) passedZero_ = 0;
    const bool follow = mayFollow(shown.time);
    if (follow) {
        for (std::size_t i = 0; i < differs_.size(); ++i)
            differs_[i] = !summary_.target[i].has_value();
    }
    wheels_->showState(summary_, shown.wheelLimit, follow);
    voltage_->showState(summary_, bench().client().now(), follow);
    const QString reason = reasonNotToDrive(snapshot);
    wheels_->setUsable(reason.isEmpty());
    voltage_->setUsable(reason.isEmpty());
    setNote(summary_.chosen == 0 ? tr("no robot chosen") : robotsText(summary_.chosen));
    showTold();
    notice_->setText(reason.isEmpty() ? refusal_ : reason);
    notice_->setForegroundRole(refusal_.isEmpty() || !reason.isEmpty() ? QPalette::PlaceholderText
                                                                       : QPalette::WindowText);
}

QString DrivePanel::reasonNotToDrive(const Snapshot* snapshot) const {
    if (snapshot == nullptr) return tr("Not connected.");
    if (bench().client().isStopped()) return tr("Everything is stopped. Re-arm to drive again.");
    if (snapshot->link != LinkState::Running)
        return tr("The link does not run: %1.").arg(describe(snapshot->link));
    if (snapshot->eStop != wire::EStop::Run) {
        return tr("The emergency stop is not in run (%1). Turn it to run.").arg(describe(snapshot->eStop));
    }
    if (summary_.chosen == 0) return tr("Choose a robot: click its tile.");
    if (summary_.live == 0)
        return tr("%1 is not heard. Switch it on, or choose another.").arg(robotsText(summary_.chosen));
    return {};
}

void DrivePanel::showTold() {
    QString text;
    if (summary_.live == 0) {
        text = tr("told: \u2014");
    } else if (summary_.toldDiffers) {
        text = tr("told: each something else");
    } else {
        text = tr("told: %1").arg(summary_.told ? toldText(*summary_.told) : QStringLiteral("\u2014"));
    }
    told_->setText(text);
}

bool DrivePanel::mayFollow(TimePoint snapshotTime) const {
    if (waiting_ > 0 || pace_.isActive()) return false;
    return snapshotTime > answeredAt_ || bench().client().now() - answeredAt_ > kSnapshotLag;
}

void DrivePanel::askWheel(int wheel, int value, bool held) {
    differs_[static_cast<std::size_t>(wheel)] = false;
    held_ = held;
    // Slower is never put off; of what comes too fast the newest is sent when its turn comes.
    if (value != 0 && pace_.isActive()) {
        late_ = true;
        return;
    }
    sendWheels();
    pace_.start(kPace);
}

void DrivePanel::sendLate() {
    if (!std::exchange(late_, false)) return;
    sendWheels();
    pace_.start(kPace);
}

void DrivePanel::askZero() {
    wheels_->reset();
    differs_.fill(false);
    held_ = false;
    sendWheels();
}

void DrivePanel::sendWheels() {
    late_ = false;
    if (summary_.live == 0) return;
    const WheelSpeeds shown = wheels_->values();
    const Snapshot* snapshot = snapshotOf(bench().session());
    if (snapshot == nullptr) return;
    std::map<WheelSpeeds, RobotMask> groups;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(summary_.live, robot)) continue;
        WheelSpeeds wheels = shown;
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            if (differs_[i]) wheels[i] = snapshot->intents[static_cast<std::size_t>(robot)].target[i];
        }
        groups[wheels] |= maskOf(robot);
    }
    passZero();
    for (const auto& [speeds, robots] : groups)
        ask(SetWheels{robots, speeds, held_});
}

void DrivePanel::passZero() {
    // The sliders rest at zero after everything that makes the engine want to see that; it is told so once.
    const RobotMask untold =
        summary_.mustPassZero ? static_cast<RobotMask>(summary_.live & ~passedZero_) : RobotMask{0};
    if (untold == 0) return;
    passedZero_ |= untold;
    ask(SetWheels{untold, {}, true});
}

void DrivePanel::ask(const thunderbots::Command& command) {
    ++waiting_;
    refusal_.clear();
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) { answered(result); });
}

void DrivePanel::answered(const Result<void>& result) {
    --waiting_;
    answeredAt_ = bench().client().now();
    if (result) return;
    refusal_ = describe(result.error()).line();
    passedZero_ = 0;
    refresh();
}

void DrivePanel::closed() {
    if (bench().isActive()) bench().client().stop(StopReason::PanelClosed);
}

void DrivePanel::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    const bool wide = event->size().width() >= kWideEnough;
    boxes_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    voltage_->setMinimumWidth(wide ? kVoltageWidth : 0);
}

}  // namespace kickstand::ui
