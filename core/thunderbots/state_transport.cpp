#include "core/thunderbots/state_transport.h"

#include <utility>

#include "core/thunderbots/retry.h"
#include "core/thunderbots/wire/dongle.h"

namespace kickstand::thunderbots {
namespace {

constexpr Duration kKeepAliveAfter = std::chrono::milliseconds(300);
constexpr std::uint8_t kEndpoint = wire::address(wire::Endpoint::StateOut);

}  // namespace

StateTransport::StateTransport(UsbLink& link, Scheduler& scheduler, const StopLatch& stop,
                               std::function<void(Error)> failed)
    : link_(link), scheduler_(scheduler), stop_(stop), failed_(std::move(failed)) {}

void StateTransport::open() {
    close();
    open_ = true;
    lastSent_ = scheduler_.now();
}

void StateTransport::close() {
    ++connection_;
    open_ = false;
    inFlight_ = false;
    dirty_ = 0;
    stallsInRow_ = 0;
    wanted_.fill(wire::brakedBlock());
    while (!drained_.empty()) {
        const auto drained = std::move(drained_.front());
        drained_.pop_front();
        drained(false);
    }
}

Result<void> StateTransport::set(int robot, const wire::DriveBlock& block) {
    if (const auto encoded = wire::encodeDrive(block); !encoded) {
        Error error = wire::toError(encoded.error(), "drive");
        error.robot = robot;
        return fail(std::move(error));
    }
    wire::DriveBlock& wanted = wanted_[static_cast<std::size_t>(robot)];
    if (wanted == block) return {};
    wanted = block;
    dirty_ |= maskOf(robot);
    pump();
    return {};
}

void StateTransport::brakeAll() {
    wanted_.fill(wire::brakedBlock());
    dirty_ = kAllRobots;
    pump();
}

bool StateTransport::keepAliveIfDue() {
    if (!open_ || inFlight_ || scheduler_.now() - lastSent_ < kKeepAliveAfter) return false;
    submit({}, 0);
    return true;
}

void StateTransport::whenDrained(std::function<void(bool)> drained) {
    if (!open_) {
        drained(false);
        return;
    }
    drained_.push_back(std::move(drained));
    tellIfDrained();
}

void StateTransport::tellIfDrained() {
    // One at a time: what is told may end the connection, and then the rest has been told so already.
    while (open_ && dirty_ == 0 && !inFlight_ && !drained_.empty()) {
        const auto drained = std::move(drained_.front());
        drained_.pop_front();
        drained(true);
    }
}

void StateTransport::pump() {
    if (!open_ || inFlight_ || dirty_ == 0) return;
    wire::StatePacketBuilder packet;
    RobotMask robots = 0;
    int last = next_;
    for (int i = 0; i < kRobots && !packet.full(); ++i) {
        const int robot = (next_ + i) % kRobots;
        if (!contains(dirty_, robot)) continue;
        const bool stopped = stop_.isSet();
        const auto& block = stopped ? wire::brakedBlock() : wanted_[static_cast<std::size_t>(robot)];
        // set() has encoded every block before: it fits, and five of them fit a packet.
        if (packet.add(static_cast<std::uint8_t>(robot), block)) robots |= maskOf(robot);
        last = robot;
    }
    next_ = (last + 1) % kRobots;
    dirty_ &= static_cast<RobotMask>(~robots);
    submit(packet.packet(), robots);
}

void StateTransport::submit(ByteView packet, RobotMask robots) {
    inFlight_ = true;
    const auto submitted = link_.submitOut(
        kEndpoint, packet, [this, connection = connection_, robots](const UsbCompletion& completion) {
            completed(connection, robots, completion);
        });
    if (submitted) return;
    // The link is on its way down and its loss will be told in a moment; nothing must look as if it had been
    // sent.
    inFlight_ = false;
    open_ = false;
}

void StateTransport::completed(std::uint64_t connection, RobotMask robots, const UsbCompletion& completion) {
    if (connection != connection_) return;
    inFlight_ = false;
    switch (completion.status) {
        case UsbStatus::Completed:
            stallsInRow_ = 0;
            lastSent_ = scheduler_.now();
            pump();
            tellIfDrained();
            return;
        case UsbStatus::Cancelled:
        case UsbStatus::NoDevice:
            return;
        default:
            stalled(robots);
    }
}

void StateTransport::stalled(RobotMask robots) {
    if (++stallsInRow_ > kStallRetries) {
        Error error;
        error.code = Errc::Stalled;
        error.endpoint = kEndpoint;
        error.got = kStallRetries;
        failed_(std::move(error));
        return;
    }
    dirty_ |= robots;
    inFlight_ = true;
    link_.clearHalt(kEndpoint, [this, connection = connection_](const UsbCompletion&) {
        if (connection != connection_) return;
        inFlight_ = false;
        pump();
        tellIfDrained();
    });
}

}  // namespace kickstand::thunderbots
