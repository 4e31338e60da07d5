#include "core/thunderbots/robot_requests.h"

#include <utility>

namespace kickstand::thunderbots {

RobotRequests::RobotRequests(Scheduler& scheduler, MessagePipe& pipe)
    : changed_([this] { ++version_; }), turns_(scheduler, pipe) {
    for (int robot = 0; robot < kRobots; ++robot)
        channels_.push_back(std::make_unique<RequestChannel>(robot, scheduler, turns_, changed_));
}

Result<void> RobotRequests::begin(int robot, const std::vector<wire::FillPageRequest>& fills,
                                  const wire::FirmwareRequest& request, int attempts, Done done, Gate gate) {
    return at(robot).ask(
        fills, request, attempts,
        [this, robot, done = std::move(done)](Result<wire::FirmwareResponse> result) {
            if (result && listener_) listener_(robot, *result);
            done(std::move(result));
        },
        std::move(gate));
}

Result<void> RobotRequests::ask(int robot, const wire::FirmwareRequest& request, Done done, Gate gate) {
    return begin(robot, {}, request, RequestChannel::kAttempts, std::move(done), std::move(gate));
}

Result<void> RobotRequests::askOnce(int robot, const wire::FirmwareRequest& request, Done done, Gate gate) {
    return begin(robot, {}, request, 1, std::move(done), std::move(gate));
}

Result<void> RobotRequests::program(int robot, const std::vector<wire::FillPageRequest>& fills,
                                    const wire::ProgramPageRequest& request, Done done) {
    return begin(robot, fills, request, 1, std::move(done), {});
}

void RobotRequests::cancel(int robot) {
    at(robot).abandon(Error{.code = Errc::Cancelled});
}

void RobotRequests::received(ByteView packet) {
    const auto message = wire::decodeMessagePacket(packet, wire::Direction::In);
    if (message && message->pipe == wire::Pipe::FirmwareResponse)
        at(message->robot).received(message->payload);
}

void RobotRequests::lost(int robot, Errc why) {
    at(robot).lost(Error{.code = why});
}

}  // namespace kickstand::thunderbots
