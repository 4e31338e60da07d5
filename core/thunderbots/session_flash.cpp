// What a session does about uploads: when a robot may be erased, and what the others may do meanwhile.

#include <cmath>
#include <utility>

#include "core/thunderbots/parameters.h"
#include "core/thunderbots/session.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots {
namespace {

Error about(int robot, Errc code, std::string subject = {}) {
    Error error;
    error.code = code;
    error.robot = robot;
    error.subject = std::move(subject);
    return error;
}

Error outOfVolts(int robot, Errc code, double volts, double limit_V) {
    Error error = about(robot, code);
    // Rounded down, so that what is just below a limit never reads as the limit.
    error.got = static_cast<std::int64_t>(volts);
    (code == Errc::BatteryLow ? error.lowest : error.highest) = std::lround(limit_V);
    return error;
}

/// One image, or the microcontroller's and then the FPGA's: the other way round the second would erase the
/// first (protocol 6.7).
bool makeSense(const std::vector<SharedFlashPlan>& plans) {
    if (plans.empty() || plans.size() > 2) return false;
    for (const SharedFlashPlan& plan : plans) {
        if (!plan || plan->pages().empty()) return false;
    }
    return plans.size() == 1 || (plans[0]->target() == image::FlashTarget::Microcontroller &&
                                 plans[1]->target() == image::FlashTarget::Fpga);
}

}  // namespace

Result<void> Session::checkCapacitor(int robot, bool unknownWillDo) const {
    const RobotState& state = model_.robot(robot);
    const bool known = state.freshness == Freshness::Current;
    // What nobody has measured may be charged, and what was on a capacitor that nobody measures any more may
    // still be there.
    if (!known && unknownWillDo) return {};
    if (!state.capacitor) return fail(about(robot, Errc::ReadingsUnknown));
    if (state.capacitor->last_V < wire::kCapacitorLive_V) return {};
    return fail(outOfVolts(robot, Errc::CapacitorLive, state.capacitor->last_V, wire::kCapacitorLive_V));
}

Result<void> Session::checkAtRest(int robot, const FlashOptions& options) const {
    if (host_.stop.isSet()) return fail(about(robot, Errc::StopLatched));
    const RobotState& state = model_.robot(robot);
    if (!state.live) return fail(about(robot, Errc::RobotNotAlive));
    const RobotIntent& intent = driver(robot).intent();
    if (const char* unrest = intent.unrest()) return fail(about(robot, Errc::NotBraked, unrest));
    if (intent.highVoltageArmed) return fail(about(robot, Errc::NotBraked, "high voltage"));
    if (auto empty = checkCapacitor(robot, options.capacitorUnknown); !empty) return empty;
    const bool known = state.freshness == Freshness::Current;
    if (known && !options.lowBattery && state.readings.battery_V < wire::kBatteryEmpty_V) {
        return fail(outOfVolts(robot, Errc::BatteryLow, state.readings.battery_V, wire::kBatteryEmpty_V));
    }
    return {};
}

Result<void> Session::checkStartFlash(int robot) const {
    if (auto askable = checkAskable(robot); !askable) return askable;
    if (parameters_.state(robot).standing == ParameterStanding::Applied)
        return fail(about(robot, Errc::NotCommitted));
    return {};
}

void Session::perform(CommandId id, const StartFlash& command) {
    if (!makeSense(command.plans)) {
        host_.answer(id, fail(Errc::BadArgument, "images"));
        return;
    }
    const auto check = [this, &command](int robot) -> Result<void> {
        if (auto may = checkStartFlash(robot); !may) return may;
        return checkAtRest(robot, command.options);
    };
    forRobots(id, command.robots, check, [this, &command](int robot) -> Result<void> {
        flashOptions_[static_cast<std::size_t>(robot)] = command.options;
        // Whatever was held or asked for before does not come back afterwards.
        driver(robot).halt();
        std::int64_t pages = 0;
        for (const SharedFlashPlan& plan : command.plans)
            pages += static_cast<std::int64_t>(plan->pages().size());
        raise(EventKind::FlashStarted, robot, pages, static_cast<std::int64_t>(command.plans.size()));
        flash_.start(robot, command.plans);
        return {};
    });
}

void Session::perform(CommandId id, const CancelFlash& command) {
    const auto check = [this](int robot) -> Result<void> {
        if (flash_.running(robot)) return {};
        return fail(about(robot, Errc::FlashNotRunning));
    };
    forRobots(id, command.robots, check, [this](int robot) -> Result<void> {
        flash_.cancel(robot);
        return {};
    });
}

void Session::perform(CommandId id, const ResumeFlash& command) {
    const auto check = [this](int robot) -> Result<void> {
        if (host_.stop.isSet()) return fail(about(robot, Errc::StopLatched));
        if (flash_.running(robot)) return {};
        return fail(about(robot, Errc::FlashNotRunning));
    };
    forRobots(id, command.robots, check, [this](int robot) -> Result<void> {
        if (flash_.progress(robot)->paused) raise(EventKind::FlashResumed, robot);
        flash_.resume(robot);
        return {};
    });
}

bool Session::wentWithItsRobot() const {
    if (!controller_.isCable()) return false;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (requests_.rebooting(robot) || flash_.expectsLoss(robot)) return true;
    }
    return false;
}

void Session::flashEnded(int robot, const FlashProgress& progress) {
    host_.event(Event{EventKind::FlashEnded,
                      host_.scheduler.now(),
                      robot,
                      progress.error ? static_cast<std::int64_t>(progress.error->code) : 0,
                      static_cast<std::int64_t>(progress.left),
                      seconds(progress.endedAt - progress.beganAt),
                      {}});
}

}  // namespace kickstand::thunderbots
