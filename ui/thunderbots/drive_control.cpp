#include "ui/thunderbots/drive_control.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/words.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

using namespace std::chrono_literals;

/// A mouse may speak a thousand times a second: no faster than this.
constexpr auto kPace = 8ms;
/// A snapshot follows an answer within this, if anything changed at all.
constexpr auto kSnapshotLag = 100ms;

bool anyMoves(const WheelSpeeds& wheels) {
    return std::any_of(wheels.begin(), wheels.end(), [](int speed) { return speed != 0; });
}

}  // namespace

DriveControl::DriveControl(RobotChoice& choice) : choice_(choice) {
    pace_.setSingleShot(true);
    pace_.setTimerType(Qt::PreciseTimer);
    connect(&pace_, &QTimer::timeout, this, &DriveControl::sendLate);
}

void DriveControl::attach(Bench& bench) {
    if (bench_ != nullptr) return;
    bench_ = &bench;
    connect(&choice_, &RobotChoice::changed, this, [this] {
        // What is held no longer holds those that were chosen before; what was set for them stays theirs.
        if (driver_) zero();
        drop();
        refresh();
    });
    connect(bench_, &Bench::changed, this, &DriveControl::refresh);
    connect(&bench_->client(), &EngineClient::stopChanged, this, [this] {
        drop();
        // The snapshot at hand is of before.
        answeredAt_ = bench_->client().now();
        refresh();
    });
    refresh();
}

void DriveControl::drop() {
    late_ = false;
    held_ = false;
    driver_.reset();
    passedZero_ = 0;
    refusal_.clear();
    wish_.fill(0);
    emit dropped();
}

void DriveControl::refresh() {
    const Snapshot* snapshot = snapshotOf(bench_->session());
    static const Snapshot nothing;
    const Snapshot& shown = snapshot == nullptr ? nothing : *snapshot;
    if (connections_ != shown.connections) {
        connections_ = shown.connections;
        drop();
    }
    limit_ = shown.wheelLimit;
    summary_ = summarize(shown, choice_.chosen());
    if (!summary_.mustPassZero) passedZero_ = 0;
    const bool waits = waiting_ > 0 || pace_.isActive();
    follows_ = !waits && (shown.time > answeredAt_ || bench_->client().now() - answeredAt_ > kSnapshotLag);
    if (follows_) {
        for (std::size_t i = 0; i < wish_.size(); ++i) {
            differs_[i] = !summary_.target[i].has_value();
            wish_[i] = summary_.target[i].value_or(0);
        }
    }
    reason_ = findReason(snapshot);
    emit changed();
}

QString DriveControl::findReason(const Snapshot* snapshot) const {
    if (snapshot == nullptr) return tr("Not connected.");
    if (snapshot->link == LinkState::Searching) return tr("The dongle or cable is not there. Plug it in.");
    if (snapshot->link != LinkState::Running)
        return tr("The link does not run: %1.").arg(describe(snapshot->link));
    if (snapshot->eStop != wire::EStop::Run) {
        return tr("The emergency stop is not in run (%1). Turn it to run.").arg(describe(snapshot->eStop));
    }
    // Only now: before, to re-arm would not help yet.
    if (bench_->client().isStopped()) return tr("Everything is stopped. Re-arm to drive again.");
    if (summary_.chosen == 0) return tr("Choose a robot: click its tile.");
    if (summary_.live == 0)
        return tr("Not heard: %1. Switch it on, or choose another.").arg(robotsText(summary_.chosen));
    return {};
}

bool DriveControl::mayDrive(DriveInput input, bool held, bool moving) {
    if (driver_ && *driver_ != input) return false;
    if (held && moving) {
        driver_ = input;
    } else {
        driver_.reset();
    }
    return true;
}

void DriveControl::setWheel(int wheel, int speed, bool held) {
    WheelSpeeds wheels = wish_;
    wheels[static_cast<std::size_t>(wheel)] = speed;
    if (!mayDrive(DriveInput::Panel, held, anyMoves(wheels))) return;
    differs_[static_cast<std::size_t>(wheel)] = false;
    wish_ = wheels;
    held_ = held;
    // Slower is never put off.
    if (speed == 0) {
        send();
    } else {
        sendSoon();
    }
}

bool DriveControl::setWheels(DriveInput input, const WheelSpeeds& wheels, bool held) {
    if (!mayDrive(input, held, anyMoves(wheels))) return false;
    differs_.fill(false);
    wish_ = wheels;
    held_ = held;
    if (anyMoves(wheels)) {
        sendSoon();
    } else {
        send();
    }
    return true;
}

void DriveControl::run() {
    held_ = false;
    send();
}

void DriveControl::zero() {
    emit dropped();
    driver_.reset();
    differs_.fill(false);
    wish_.fill(0);
    held_ = false;
    send();
}

void DriveControl::brake() {
    emit dropped();
    driver_.reset();
    late_ = false;
    wish_.fill(0);
    if (summary_.live != 0) ask(Brake{summary_.live});
}

void DriveControl::setDribbler(bool on) {
    if (summary_.live != 0) ask(SetDribbler{summary_.live, on});
}

void DriveControl::setLimit(int limit) {
    ask(SetWheelLimit{limit});
}

void DriveControl::sendSoon() {
    // Of what comes too fast the newest is sent when its turn comes.
    if (pace_.isActive()) {
        late_ = true;
        return;
    }
    send();
    pace_.start(kPace);
}

void DriveControl::sendLate() {
    if (!std::exchange(late_, false)) return;
    send();
    pace_.start(kPace);
}

void DriveControl::send() {
    late_ = false;
    const Snapshot* snapshot = snapshotOf(bench_->session());
    if (summary_.live == 0 || snapshot == nullptr) return;
    std::map<WheelSpeeds, RobotMask> groups;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(summary_.live, robot)) continue;
        WheelSpeeds wheels = wish_;
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            if (differs_[i]) wheels[i] = snapshot->intents[static_cast<std::size_t>(robot)].target[i];
        }
        groups[wheels] |= maskOf(robot);
    }
    passZero();
    for (const auto& [speeds, robots] : groups)
        ask(SetWheels{robots, speeds, held_});
}

void DriveControl::passZero() {
    // Every input rests at zero after what makes the engine want to see that; it is told so once.
    const RobotMask untold =
        summary_.mustPassZero ? static_cast<RobotMask>(summary_.live & ~passedZero_) : RobotMask{0};
    if (untold == 0) return;
    passedZero_ |= untold;
    ask(SetWheels{untold, {}, true});
}

void DriveControl::ask(const thunderbots::Command& command) {
    ++waiting_;
    follows_ = false;
    refusal_.clear();
    bench_->submit(SystemCommand{command}, this, [this](const Result<void>& result) { answered(result); });
}

void DriveControl::answered(const Result<void>& result) {
    --waiting_;
    answeredAt_ = bench_->client().now();
    if (result) return;
    refusal_ = describe(result.error()).line();
    passedZero_ = 0;
    refresh();
}

}  // namespace kickstand::ui
