// What a session does with each command: every rule about what may move, charge or fire stands here.

#include <utility>

#include "core/thunderbots/session.h"
#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::thunderbots {
namespace {

/// A kick that has not gone by then is dropped: it would come as a surprise.
constexpr Duration kKickExpiry = std::chrono::milliseconds(200);

Error about(int robot, Errc code, std::string subject = {}) {
    Error error;
    error.code = code;
    error.robot = robot;
    error.subject = std::move(subject);
    return error;
}

bool isRobot(int robot) {
    return robot >= 0 && robot < kRobots;
}

Error noSuchRobot(int robot) {
    Error error;
    error.code = Errc::OutOfRange;
    error.subject = "robot";
    error.lowest = 0;
    error.highest = kRobots - 1;
    error.got = robot;
    return error;
}

/// A kick that a robot would do nothing with.
bool isEmpty(const wire::KickTimes& times) {
    const auto pulses = wire::pulsesOf(times);
    return pulses[0].width_us == 0 && pulses[1].width_us == 0;
}

}  // namespace

void Session::execute(CommandId id, const Command& command) {
    std::visit([this, id](const auto& body) { perform(id, body); }, command);
    ++version_;
}

Result<void> Session::checkRunning() const {
    if (controller_.state() != LinkState::Running || restarting_ || ending_) return fail(Errc::NotConnected);
    return {};
}

Result<void> Session::checkReady(int robot) const {
    if (host_.stop.isSet()) return fail(about(robot, Errc::StopLatched));
    if (!heartbeatFresh_) return fail(about(robot, Errc::HeartbeatStale));
    if (model_.status().eStop != wire::EStop::Run) return fail(about(robot, Errc::EmergencyStopNotRun));
    if (!model_.robot(robot).live) return fail(about(robot, Errc::RobotNotAlive));
    if (flash_.running(robot)) return fail(about(robot, Errc::FlashRunning));
    return {};
}

Result<void> Session::checkMayMove(int robot) const {
    if (checker_.running(robot)) return fail(about(robot, Errc::CheckRunning));
    return checkReady(robot);
}

Result<void> Session::checkHighVoltage(int robot) const {
    if (auto may = checkMayMove(robot); !may) return may;
    if (!driver(robot).intent().highVoltageArmed) return fail(about(robot, Errc::NotArmed));
    return {};
}

void Session::forRobots(CommandId id, RobotMask robots, const std::function<Result<void>(int)>& check,
                        const std::function<Result<void>(int)>& one) {
    Result<void> answer = checkRunning();
    if (answer && robots == 0) answer = fail(Errc::BadArgument, "robots");
    if (!answer) robots = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(robots, robot)) continue;
        Result<void> done = check(robot);
        if (done) done = one(robot);
        if (done) sendBlock(robot);
        if (!done && answer) {
            done.error().robot = robot;
            answer = std::move(done);
        }
    }
    host_.answer(id, std::move(answer));
}

void Session::perform(CommandId id, const SetWheels& command) {
    const TimePoint now = host_.scheduler.now();
    const bool stopping = command.wheels == WheelSpeeds{};
    const auto check = [this, &command, stopping](int robot) -> Result<void> {
        auto may = checkMayMove(robot);
        // An input that is let go counts at any time; one that is pressed while it may not must be let go
        // first.
        if (!may && command.held && !stopping) driver(robot).refuseHeld();
        if (!may && command.held && stopping) driver(robot).noteZero();
        return may;
    };
    forRobots(id, command.robots, check, [this, &command, now](int robot) -> Result<void> {
        auto set = driver(robot).setWheels(command.wheels, command.held, wheelLimit_, now);
        if (set) driver(robot).advance(now, wheelLimit_ <= kStartingWheelLimit);
        return set;
    });
}

void Session::perform(CommandId id, const Brake& command) {
    forRobots(
        id, command.robots, [](int) -> Result<void> { return {}; },
        [this](int robot) -> Result<void> {
            if (checker_.running(robot)) endCheck(Errc::Cancelled);
            driver(robot).brake();
            return {};
        });
}

void Session::perform(CommandId id, const SetWheelLimit& command) {
    if (auto running = checkRunning(); !running) {
        host_.answer(id, std::move(running));
        return;
    }
    if (command.limit < 0 || command.limit > kFastestWheel) {
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = "limit";
        error.lowest = 0;
        error.highest = kFastestWheel;
        error.got = command.limit;
        host_.answer(id, fail(std::move(error)));
        return;
    }
    const int before = std::exchange(wheelLimit_, command.limit);
    for (int robot = 0; robot < kRobots; ++robot) {
        // Lowering it must not leave a robot running faster than what is allowed now.
        if (!driver(robot).clampTo(wheelLimit_)) continue;
        driver(robot).advance(host_.scheduler.now(), wheelLimit_ <= kStartingWheelLimit);
        sendBlock(robot);
    }
    raise(EventKind::WheelLimit, -1, command.limit, before);
    host_.answer(id, {});
}

void Session::perform(CommandId id, const SetDribbler& command) {
    forRobots(
        id, command.robots,
        [this, &command](int robot) { return command.on ? checkMayMove(robot) : Result<void>{}; },
        [this, &command](int robot) -> Result<void> {
            // A check would switch it on again.
            if (checker_.running(robot)) endCheck(Errc::Cancelled);
            driver(robot).setDribbler(command.on);
            return {};
        });
}

void Session::perform(CommandId id, const ArmHighVoltage& command) {
    forRobots(
        id, command.robots,
        [this, &command](int robot) { return command.armed ? checkMayMove(robot) : Result<void>{}; },
        [this, &command](int robot) -> Result<void> {
            const bool before = driver(robot).intent().highVoltageArmed;
            if (!command.armed && discharger_.running(robot))
                endDischarge(robot, static_cast<std::int64_t>(Errc::NotArmed));
            if (!command.armed && sweeper_.running(robot)) endSweep(Errc::NotArmed);
            if (!command.armed && checker_.running(robot)) endCheck(Errc::NotArmed);
            driver(robot).armHighVoltage(command.armed);
            if (before != command.armed) raise(EventKind::HighVoltage, robot, command.armed ? 1 : 0);
            return {};
        });
}

void Session::perform(CommandId id, const SetCharger& command) {
    forRobots(
        id, command.robots,
        [this, &command](int robot) { return command.on ? checkHighVoltage(robot) : Result<void>{}; },
        [this, &command](int robot) -> Result<void> {
            if (command.on && discharger_.running(robot))
                endDischarge(robot, static_cast<std::int64_t>(Errc::Cancelled));
            if (checker_.running(robot)) endCheck(Errc::Cancelled);
            driver(robot).setCharger(command.on);
            return {};
        });
}

void Session::perform(CommandId id, const SetAutokick& command) {
    forRobots(
        id, command.robots,
        [this, &command](int robot) -> Result<void> {
            if (!command.armed) return {};
            if (auto may = checkHighVoltage(robot); !may) return may;
            if (auto free = checkNotSweeping(robot); !free) return free;
            if (wire::isNoAutokick(command.times) || isEmpty(command.times))
                return fail(about(robot, Errc::NoEncoding, "autokick"));
            if (const auto encoded = wire::encodeKick(command.times); !encoded)
                return fail(wire::toError(encoded.error(), "autokick"));
            return {};
        },
        [this, &command](int robot) -> Result<void> {
            if (command.armed && discharger_.running(robot))
                endDischarge(robot, static_cast<std::int64_t>(Errc::Cancelled));
            if (command.armed) kickLog_.autokickSet(robot, command.times);
            driver(robot).setAutokick(command.armed, command.times);
            return {};
        });
}

void Session::perform(CommandId id, const SetTestMode& command) {
    const auto encoded = wire::encodeTestMode(command.mode);
    const bool inBlock = command.way == TestModeWay::DriveBlock;
    wire::DriveBlock block;
    block.testClass = static_cast<std::uint8_t>(command.mode.testClass);
    block.testTarget = command.mode.target;
    const auto fits = wire::encodeDrive(block);
    const auto check = [this, inBlock, &encoded, &fits](int robot) -> Result<void> {
        if (!encoded) return fail(wire::toError(encoded.error(), "test mode"));
        // A message is shown and moves nothing. A block is a keep-alive too: none but braked ones go while
        // STOP is latched or nobody is there.
        if (inBlock && !fits) return fail(wire::toError(fits.error(), "test mode"));
        if (inBlock && host_.stop.isSet()) return fail(about(robot, Errc::StopLatched));
        if (inBlock && !heartbeatFresh_) return fail(about(robot, Errc::HeartbeatStale));
        if (inBlock && checker_.running(robot)) return fail(about(robot, Errc::CheckRunning));
        if (!model_.robot(robot).live) return fail(about(robot, Errc::RobotNotAlive));
        return {};
    };
    forRobots(id, command.robots, check, [this, inBlock, &command, &encoded](int robot) -> Result<void> {
        if (inBlock) {
            driver(robot).setTestMode(command.mode);
            return {};
        }
        OutMessage message;
        message.robot = robot;
        message.pipe = wire::Pipe::TestMode;
        message.payload.append(*encoded);
        return controller_.messages().push(message, [](const Result<void>&) {});
    });
}

void Session::perform(CommandId id, const ClearExperiment& command) {
    for (int robot = 0; robot < kRobots; ++robot) {
        if (contains(command.robots, robot)) model_.clearExperiment(robot);
    }
    host_.answer(id, {});
}

Result<void> Session::giveKick(int robot, const wire::KickTimes& times, std::optional<KickCause> cause,
                               std::function<void(Result<void>)> done) {
    const auto encoded = wire::encodeKick(times);
    if (!encoded) return fail(wire::toError(encoded.error(), "kick"));
    OutMessage message;
    message.robot = robot;
    message.pipe = wire::Pipe::Kick;
    message.payload.append(*encoded);
    message.expires = host_.scheduler.now() + kKickExpiry;
    kickOutstanding_ = true;
    kickLog_.expect(cause);
    auto pushed =
        controller_.messages().push(message, [this, robot, done = std::move(done)](Result<void> result) {
            kickOutstanding_ = false;
            ++version_;
            if (!result) raise(EventKind::KickDropped, robot, static_cast<std::int64_t>(result.error().code));
            done(std::move(result));
        });
    if (!pushed) kickOutstanding_ = false;
    return pushed;
}

void Session::perform(CommandId id, const Kick& command) {
    const auto refusal = [this, &command]() -> Result<void> {
        if (!isRobot(command.robot)) return fail(noSuchRobot(command.robot));
        if (auto running = checkRunning(); !running) return running;
        if (auto may = checkHighVoltage(command.robot); !may) return may;
        if (auto free = checkNotSweeping(command.robot); !free) return free;
        if (isEmpty(command.times)) return fail(about(command.robot, Errc::NoEncoding, "kick"));
        if (kickOutstanding_) return fail(about(command.robot, Errc::KickOutstanding));
        return {};
    }();
    if (!refusal) {
        host_.answer(id, refusal);
        return;
    }
    auto given = giveKick(command.robot, command.times, KickCause::Asked,
                          [this, id](Result<void> result) { host_.answer(id, std::move(result)); });
    if (!given) host_.answer(id, std::move(given));
}

void Session::perform(CommandId id, const Discharge& command) {
    Result<void> answer = checkRunning();
    if (!isRobot(command.robot)) answer = fail(noSuchRobot(command.robot));
    if (answer && command.on) answer = checkHighVoltage(command.robot);
    if (answer && command.on) answer = checkNotSweeping(command.robot);
    if (!answer) {
        host_.answer(id, std::move(answer));
        return;
    }
    const RobotState& robot = model_.robot(command.robot);
    if (!command.on) {
        if (checker_.running(command.robot)) endCheck(Errc::Cancelled);
        if (discharger_.running(command.robot))
            endDischarge(command.robot, static_cast<std::int64_t>(Errc::Cancelled));
    } else if (robot.freshness != Freshness::Current) {
        answer = fail(about(command.robot, Errc::ReadingsUnknown));
    } else if (!discharger_.running(command.robot)) {
        beginDischarge(command.robot);
    }
    host_.answer(id, std::move(answer));
}

void Session::perform(CommandId id, const SetChannels& command) {
    const wire::Channels channels{command.channel0, command.channel1};
    Result<void> answer = checkRunning();
    if (const auto value = wire::encodeChannelsValue(channels); !value)
        answer = fail(wire::toError(value.error(), "channels"));
    if (answer && controller_.isCable()) answer = fail(Errc::Unsupported, "channels");
    if (!answer) {
        host_.answer(id, std::move(answer));
        return;
    }
    halt();
    restarting_ = true;
    restartDeadline_ = host_.scheduler.callAfter(kLastBlocksLimit, [this, id] {
        restartDeadline_ = 0;
        restarting_ = false;
        host_.answer(id, fail(Errc::TimedOut, "channels"));
    });
    controller_.stateTransport().whenDrained([this, id, channels, deadline = restartDeadline_](bool taken) {
        if (restartDeadline_ != deadline) return;
        host_.scheduler.cancel(std::exchange(restartDeadline_, 0));
        restarting_ = false;
        if (!taken || ending_) {
            host_.answer(id, fail(Errc::Disconnected));
            return;
        }
        raise(EventKind::Channels, -1, channels.channel0, channels.channel1);
        resetConnection();
        lastState_ = LinkState::Idle;
        controller_.close([this, channels] {
            if (!ending_) controller_.start(channels);
        });
        host_.answer(id, {});
    });
}

}  // namespace kickstand::thunderbots
