// What a session does about robots' parameters: who may be asked what, and when a reboot is safe.

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

Error noSuchRobot(int robot) {
    Error error = about(robot, Errc::OutOfRange, "robot");
    error.robot.reset();
    error.lowest = 0;
    error.highest = kRobots - 1;
    error.got = robot;
    return error;
}

}  // namespace

RobotMask Session::aliveRobots() const {
    RobotMask alive = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (model_.robot(robot).live) alive = static_cast<RobotMask>(alive | maskOf(robot));
    }
    return alive;
}

Result<void> Session::checkAskable(int robot) const {
    if (robot < 0 || robot >= kRobots) return fail(noSuchRobot(robot));
    if (auto running = checkRunning(); !running) return running;
    if (!model_.robot(robot).live) return fail(about(robot, Errc::RobotNotAlive));
    if (flash_.running(robot)) return fail(about(robot, Errc::FlashRunning));
    if (requests_.busy(robot)) return fail(about(robot, Errc::RequestPending));
    return {};
}

Result<void> Session::checkApply(const ApplyParameters& command) const {
    if (auto askable = checkAskable(command.robot); !askable) return askable;
    const ParameterState& state = parameters_.state(command.robot);
    if (!state.robot) return fail(about(command.robot, Errc::ParametersUnread));
    // What nobody knows the meaning of is only ever written back.
    if (state.robot->tail != command.parameters.tail)
        return fail(about(command.robot, Errc::BadArgument, "tail"));
    if (auto legal = wire::checkParameters(command.parameters); !legal)
        return fail(wire::toError(legal.error(), "parameters"));
    return {};
}

Result<void> Session::checkReboot(const RebootRobot& command) const {
    if (auto askable = checkAskable(command.robot); !askable) return askable;
    if (host_.stop.isSet()) return fail(about(command.robot, Errc::StopLatched));
    if (const char* unrest = driver(command.robot).intent().unrest())
        return fail(about(command.robot, Errc::NotBraked, unrest));
    if (auto empty = checkCapacitor(command.robot, command.capacitorUnknown); !empty) return empty;
    if (!command.discard && parameters_.state(command.robot).standing == ParameterStanding::Applied)
        return fail(about(command.robot, Errc::NotCommitted));
    return {};
}

ParameterService::Done Session::answering(CommandId id) {
    return [this, id](Result<void> result) { host_.answer(id, std::move(result)); };
}

void Session::perform(CommandId id, const ReadParameters& command) {
    if (auto may = checkAskable(command.robot); !may) {
        host_.answer(id, std::move(may));
        return;
    }
    parameters_.read(command.robot, answering(id));
}

void Session::perform(CommandId id, const ReadSignatures& command) {
    if (auto may = checkAskable(command.robot); !may) {
        host_.answer(id, std::move(may));
        return;
    }
    parameters_.readSignatures(command.robot, answering(id));
}

void Session::perform(CommandId id, const ApplyParameters& command) {
    if (auto may = checkApply(command); !may) {
        host_.answer(id, std::move(may));
        return;
    }
    parameters_.apply(command.robot, command.parameters, answering(id));
}

void Session::perform(CommandId id, const CommitParameters& command) {
    Result<void> may = checkAskable(command.robot);
    if (may && !parameters_.state(command.robot).robot)
        may = fail(about(command.robot, Errc::ParametersUnread));
    if (!may) {
        host_.answer(id, std::move(may));
        return;
    }
    parameters_.commit(command.robot, answering(id));
}

void Session::perform(CommandId id, const RebootRobot& command) {
    if (auto may = checkReboot(command); !may) {
        host_.answer(id, std::move(may));
        return;
    }
    // Disarmed, so that nothing begins meanwhile, and the robot comes back as robots come.
    driver(command.robot).halt();
    sendBlock(command.robot);
    const auto still = [this, robot = command.robot, unknown = command.capacitorUnknown]() -> Result<void> {
        if (host_.stop.isSet()) return fail(about(robot, Errc::StopLatched));
        return checkCapacitor(robot, unknown);
    };
    parameters_.reboot(command.robot, still, answering(id));
}

}  // namespace kickstand::thunderbots
