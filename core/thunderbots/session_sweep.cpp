// What a session does with a sweep: each of its kicks obeys the rules that a person's kick does.

#include <utility>

#include "core/thunderbots/session.h"

namespace kickstand::thunderbots {

Result<void> Session::checkNotSweeping(int robot) const {
    if (!sweeper_.running(robot)) return {};
    Error error;
    error.code = Errc::SweepRunning;
    error.robot = robot;
    return fail(std::move(error));
}

Result<void> Session::checkSweep(const SweepPlan& plan) const {
    if (auto running = checkRunning(); !running) return running;
    if (auto may = checkHighVoltage(plan.robot); !may) return may;
    if (sweeper_.running()) return checkNotSweeping(sweeper_.robot());
    if (model_.robot(plan.robot).freshness != Freshness::Current) {
        Error error;
        error.code = Errc::ReadingsUnknown;
        error.robot = plan.robot;
        return fail(std::move(error));
    }
    return {};
}

void Session::perform(CommandId id, const StartSweep& command) {
    const SweepPlan& plan = command.plan;
    auto kicks = planSweep(plan);
    if (!kicks) {
        host_.answer(id, fail(std::move(kicks.error())));
        return;
    }
    if (auto may = checkSweep(plan); !may) {
        host_.answer(id, std::move(may));
        return;
    }
    if (discharger_.running(plan.robot)) endDischarge(plan.robot, static_cast<std::int64_t>(Errc::Cancelled));
    const auto total = static_cast<std::int64_t>(kicks->size());
    sweeper_.begin(plan, *std::move(kicks), driver(plan.robot).intent().charger, host_.scheduler.now());
    driver(plan.robot).setSweeping(true);
    driver(plan.robot).setCharger(true);
    sendBlock(plan.robot);
    raise(EventKind::SweepStarted, plan.robot, total);
    host_.answer(id, {});
}

void Session::perform(CommandId id, const StopSweep&) {
    if (sweeper_.running()) endSweep(Errc::Cancelled);
    host_.answer(id, {});
}

void Session::stepSweep(TimePoint now) {
    using Finding = Sweeper::Finding;
    const int robot = sweeper_.robot();
    const SweepStage before = sweeper_.progress()->stage;
    const bool measuring = sweepKickOutstanding_ || kickLog_.measuring(robot);
    switch (sweeper_.look(model_.robot(robot), measuring, now)) {
        case Finding::Wait:
            break;
        case Finding::Kick:
            if (!kickOutstanding_) giveSweepKick(now);
            break;
        case Finding::Through:
            endSweep(std::nullopt);
            break;
        case Finding::NotCharged:
            endSweep(Errc::NotCharging);
            break;
        case Finding::Unknown:
            endSweep(Errc::ReadingsUnknown);
            break;
    }
    if (sweeper_.progress()->stage != before) ++version_;
}

void Session::giveSweepKick(TimePoint now) {
    const int robot = sweeper_.robot();
    Result<void> given = checkHighVoltage(robot);
    if (given) {
        const wire::KickTimes times = sweeper_.due();
        sweeper_.kicked(now);
        sweepKickOutstanding_ = true;
        const auto done = [this, sweep = sweeper_.number()](const Result<void>& result) {
            sweepKickOutstanding_ = false;
            if (result || sweep != sweeper_.number()) return;
            sweeper_.kickFailed();
            endSweep(result.error().code);
        };
        given = giveKick(robot, times, KickCause::Sweep, done);
        if (!given) done(given);
    }
    if (!given) endSweep(given.error().code);
    ++version_;
}

void Session::endSweep(std::optional<Errc> why) {
    if (!sweeper_.running()) return;
    const int robot = sweeper_.robot();
    sweeper_.end(why);
    // What the dongle has not taken yet is not to come as a surprise.
    if (sweepKickOutstanding_) controller_.messages().dropKicks(why.value_or(Errc::Cancelled));
    driver(robot).setSweeping(false);
    if (!sweeper_.chargerWasOn() || !checkHighVoltage(robot)) driver(robot).setCharger(false);
    // After STOP braked blocks go to everybody anyway.
    if (!host_.stop.isSet()) sendBlock(robot);
    ++version_;
    raise(EventKind::SweepEnded, robot, why ? static_cast<std::int64_t>(*why) : 0,
          sweeper_.progress()->given);
}

}  // namespace kickstand::thunderbots
