// What a session does with a check: all that it has a robot do obeys the rules that a person's commands do.

#include <bit>
#include <utility>

#include "core/thunderbots/session.h"
#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::thunderbots {
namespace {

Error about(int robot, Errc code) {
    Error error;
    error.code = code;
    error.robot = robot;
    return error;
}

int firstOf(RobotMask robots) {
    return std::countr_zero(robots);
}

}  // namespace

Result<void> Session::checkCheck(const CheckPlan& plan) const {
    if (auto running = checkRunning(); !running) return running;
    if (checker_.running()) return fail(about(checker_.robot(), Errc::CheckRunning));
    std::optional<Error> refusal;
    bool anyReady = false;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(plan.robots, robot)) continue;
        if (auto free = checkNotSweeping(robot); !free) return free;
        if (auto ready = checkReady(robot); !ready) {
            // One that is not heard fails by itself, when its turn comes.
            if (ready.error().code != Errc::RobotNotAlive) return ready;
            if (!refusal) refusal = ready.error();
            continue;
        }
        anyReady = true;
        if (plan.highVoltage && !driver(robot).intent().highVoltageArmed)
            return fail(about(robot, Errc::NotArmed));
    }
    if (!anyReady) return fail(refusal.value_or(about(firstOf(plan.robots), Errc::RobotNotAlive)));
    if (plan.wheels && plan.limits.wheelSpeed > wheelLimit_) {
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = "wheel_speed";
        error.lowest = 1;
        error.highest = wheelLimit_;
        error.got = static_cast<std::int64_t>(plan.limits.wheelSpeed);
        return fail(std::move(error));
    }
    return {};
}

void Session::perform(CommandId id, const StartCheck& command) {
    const CheckPlan& plan = command.plan;
    auto steps = planCheck(plan);
    if (!steps) {
        host_.answer(id, fail(std::move(steps.error())));
        return;
    }
    if (auto may = checkCheck(plan); !may) {
        host_.answer(id, std::move(may));
        return;
    }
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(plan.robots, robot)) continue;
        if (discharger_.running(robot)) endDischarge(robot, static_cast<std::int64_t>(Errc::Cancelled));
        driver(robot).setChecking(false);
        sendBlock(robot);
    }
    checker_.begin(plan, *steps, host_.scheduler.now());
    driver(checker_.robot()).setChecking(true);
    raise(EventKind::CheckStarted, -1, std::popcount(plan.robots));
    host_.answer(id, {});
}

void Session::perform(CommandId id, const AnswerCheck& command) {
    const int robot = checker_.robot();
    auto answered = checker_.answer(command.row, command.answer, host_.scheduler.now());
    if (answered && checker_.robot() != robot) leaveChecked(robot);
    host_.answer(id, std::move(answered));
}

void Session::perform(CommandId id, const StopCheck&) {
    if (checker_.running()) endCheck(Errc::Cancelled);
    host_.answer(id, {});
}

void Session::stepCheck(TimePoint now) {
    const int robot = checker_.robot();
    const std::uint64_t before = checker_.version();
    const KickRecord* lastKick = nullptr;
    const auto kicks = kickLog_.records();
    for (auto record = kicks->rbegin(); record != kicks->rend() && lastKick == nullptr; ++record) {
        if (record->robot == robot) lastKick = &*record;
    }
    const CheckDemand demanded =
        checker_.look({model_.robot(robot), lastKick, discharger_.running(robot), !kickOutstanding_}, now);
    if (checker_.robot() != robot) {
        leaveChecked(robot);
    } else if (auto done = demand(robot, demanded, now); !done) {
        checker_.failStep(done.error().code);
        if (checker_.robot() != robot) leaveChecked(robot);
    }
    if (checker_.version() != before) ++version_;
}

Result<void> Session::demand(int robot, const CheckDemand& demand, TimePoint now) {
    const RobotIntent before = driver(robot).intent();
    if (demand != CheckDemand{}) {
        if (auto ready = checkReady(robot); !ready) return ready;
    }
    const bool highVoltage = demand.charger || demand.discharge || demand.kick;
    if (highVoltage && !before.highVoltageArmed) return fail(about(robot, Errc::NotArmed));
    if (demand.wheels == WheelSpeeds{}) {
        driver(robot).brake();
    } else if (demand.wheels != before.target || !before.run) {
        if (auto set = driver(robot).setWheels(demand.wheels, false, wheelLimit_, now); !set) return set;
        driver(robot).advance(now, true);
    }
    driver(robot).setDribbler(demand.dribbler);
    driver(robot).setCharger(demand.charger);
    driver(robot).setTestMode(demand.lights);
    if (demand.discharge && !discharger_.running(robot)) beginDischarge(robot);
    if (!demand.discharge && discharger_.running(robot))
        endDischarge(robot, static_cast<std::int64_t>(Errc::Cancelled));
    const RobotIntent& after = driver(robot).intent();
    const bool changed = after.run != before.run || after.target != before.target ||
                         after.dribbler != before.dribbler || after.charger != before.charger ||
                         after.driveTestMode != before.driveTestMode;
    if (changed) sendBlock(robot);
    if (changed) ++version_;
    return demand.kick ? demandKick(robot) : Result<void>{};
}

Result<void> Session::demandKick(int robot) {
    const auto& limits = checker_.progress()->plan.limits;
    const auto encoded = wire::encodePulses({static_cast<int>(limits.kick_us), 0, 0});
    if (!encoded) return fail(wire::toError(encoded.error()));
    // Where the dongle does not take it, no record of it comes, and the step fails for want of one.
    return giveKick(robot, encoded->times, KickCause::Asked, [](const Result<void>&) {});
}

void Session::leaveChecked(int robot) {
    const auto progress = checker_.progress();
    if (discharger_.running(robot)) endDischarge(robot, static_cast<std::int64_t>(Errc::Cancelled));
    const bool armed = driver(robot).intent().highVoltageArmed;
    driver(robot).halt();
    // After STOP braked blocks go to everybody anyway.
    if (!host_.stop.isSet()) sendBlock(robot);
    if (armed) raise(EventKind::HighVoltage, robot, 0);
    if (checker_.running()) driver(checker_.robot()).setChecking(true);
    std::int64_t notPassed = 0;
    for (const CheckRow& row : progress->rows) {
        if (row.step.robot == robot && row.verdict != CheckVerdict::Passed) ++notPassed;
    }
    raise(EventKind::RobotChecked, robot, static_cast<std::int64_t>(verdictOf(*progress, robot)), notPassed);
    if (!checker_.running())
        raise(EventKind::CheckEnded, -1,
              progress->endedBy ? static_cast<std::int64_t>(*progress->endedBy) : 0);
    ++version_;
}

void Session::endCheck(Errc why) {
    const int robot = checker_.robot();
    checker_.end(why);
    leaveChecked(robot);
}

bool Session::othersBusy(int robot) const {
    for (int other = 0; other < kRobots; ++other) {
        if (other != robot && driver(other).intent().busy()) return true;
    }
    return false;
}

void Session::checkedRobotLost(int robot) {
    if (model_.isOpen() && model_.status().radios == wire::RadioState::Running) {
        checker_.robotLost(Errc::RobotNotAlive);
        leaveChecked(robot);
    } else {
        endCheck(model_.isOpen() ? Errc::RobotNotAlive : Errc::Disconnected);
    }
}

}  // namespace kickstand::thunderbots
