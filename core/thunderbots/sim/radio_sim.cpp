#include "core/thunderbots/sim/radio_sim.h"

#include <chrono>

#include "core/thunderbots/wire/micropacket.h"

namespace kickstand::thunderbots::sim {
namespace {

using std::chrono::milliseconds;

constexpr int kFailuresToDrop = 50;
constexpr Duration kPollTimeout = milliseconds(25);
constexpr Duration kIdealRetry = milliseconds(1);
// Length, pipe and sequence number before the message in an answer (protocol 5.5).
constexpr std::size_t kMessageHeaderBytes = 3;

}  // namespace

RadioSim::RadioSim(Scheduler& scheduler, RadioMedium& medium, RadioPace pace, std::vector<RobotRadio>& robots,
                   RadioHost& host)
    : scheduler_(scheduler),
      medium_(medium),
      pace_(pace),
      robots_(robots),
      host_(host),
      step_(scheduler),
      flights_(scheduler) {}

void RadioSim::start(const wire::Channels& channels) {
    stop();
    running_ = true;
    channels_ = channels;
    phase_ = Phase::FirstBroadcast;
    step_.start(Duration::zero(), [this] { pace_ == RadioPace::Ideal ? idealTick() : beginPhase(); });
}

void RadioSim::stop() {
    running_ = false;
    step_.stop();
    flights_.cancelAll();
    peers_ = {};
    cycleRobots_.clear();
}

void RadioSim::breakDown() {
    for (std::uint8_t robot = 0; robot < wire::kRobotCount; ++robot) {
        if (peers_[robot].alive) drop(robot);
    }
    stop();
}

std::uint16_t RadioSim::alive() const {
    std::uint16_t mask = 0;
    for (std::size_t robot = 0; robot < peers_.size(); ++robot) {
        if (peers_[robot].alive) mask = static_cast<std::uint16_t>(mask | 1U << robot);
    }
    return mask;
}

// ---- Frames ----

template <class Deliver>
bool RadioSim::carry(wire::Direction direction, Duration air, Deliver deliver) {
    const int copies = medium_.copies();
    for (int i = 0; i < copies; ++i) {
        const TimePoint arrival = medium_.arrival(direction, scheduler_.now() + air);
        if (arrival > scheduler_.now()) {
            flights_.at(arrival, deliver);
        } else {
            deliver();
        }
    }
    return copies > 0;
}

RobotRadio* RadioSim::find(std::uint8_t robot) {
    RobotRadio* found = nullptr;
    for (RobotRadio& one : robots_) {
        if (!one.hears(robot, channels_)) continue;
        // Two robots with one number talk over each other: neither is understood.
        if (found) return nullptr;
        found = &one;
    }
    return found;
}

void RadioSim::broadcast(std::uint8_t robot) {
    const RadioHost::DriveBytes block = host_.driveBlock(robot);
    for (RobotRadio& one : robots_) {
        if (!one.hears(robot, channels_)) continue;
        carry(wire::Direction::Out, Duration::zero(), [&one, block] { one.takeDrive(block); });
    }
}

void RadioSim::driveChanged(std::uint8_t robot) {
    if (pace_ != RadioPace::Ideal || !peers_[robot].alive) return;
    flights_.after(Duration::zero(), [this, robot] {
        if (peers_[robot].alive) broadcast(robot);
    });
}

// ---- Polls ----

void RadioSim::poll(std::uint8_t robot) {
    if (!peers_[robot].polled) peers_[robot].polled = scheduler_.now();
    carry(wire::Direction::Out, Duration::zero(), [this, robot] { answerPoll(robot); });
}

void RadioSim::messageWaiting(std::uint8_t robot) {
    if (pace_ != RadioPace::Ideal || robot >= peers_.size() || !peers_[robot].alive) return;
    flights_.after(Duration::zero(), [this, robot] {
        if (peers_[robot].alive) poll(robot);
    });
}

void RadioSim::answerPoll(std::uint8_t robot) {
    const RobotRadio* radio = find(robot);
    const auto answer = radio ? radio->poll() : std::nullopt;
    if (!answer) return;
    const std::size_t bytes = wire::kFeedbackMicropacketBytes +
                              (answer->message ? kMessageHeaderBytes + answer->message->payload.size() : 0);
    // What is still on its way when the robot is lost and found again belongs to no conversation.
    const std::uint32_t session = peers_[robot].session;
    carry(wire::Direction::In, airTime(bytes), [this, robot, session, answer = *answer] {
        if (peers_[robot].session == session) takeAnswer(robot, answer);
    });
}

void RadioSim::takeAnswer(std::uint8_t robot, const RadioAnswer& answer) {
    Peer& peer = peers_[robot];
    if (!peer.alive) return;
    peer.polled.reset();
    peer.failures = 0;
    host_.feedbackCame(robot, answer.feedback);
    if (!answer.message || !takeMessage(robot, *answer.message) || medium_.lost()) return;
    RobotRadio* radio = find(robot);
    if (!radio) return;
    radio->acknowledged(*answer.message);
    if (radio->hasMessage()) messageWaiting(robot);
}

bool RadioSim::takeMessage(std::uint8_t robot, const RadioMessage& message) {
    SequenceNumbers& next = peers_[robot].next;
    // Another number than the next is that of a message which came before: acknowledged again, not taken
    // again.
    if (message.sequence != next.of(message.pipe)) return true;
    if (!host_.messageCame(robot, message.pipe, message.payload)) return false;
    next.step(message.pipe);
    return true;
}

void RadioSim::expirePolls() {
    for (std::uint8_t robot = 0; robot < wire::kRobotCount; ++robot) {
        Peer& peer = peers_[robot];
        if (!peer.polled || scheduler_.now() < *peer.polled + kPollTimeout) continue;
        peer.polled.reset();
        failed(robot);
    }
}

// ---- Messages ----

void RadioSim::send(std::uint8_t robot, wire::Pipe pipe, ByteView payload) {
    Peer& peer = peers_[robot];
    RadioMessage message;
    message.pipe = pipe;
    message.payload.append(payload);
    peer.outgoing.push_back(message);
    if (pace_ == RadioPace::Ideal && peer.outgoing.size() == 1)
        flights_.after(Duration::zero(), [this, robot] { transmit(robot); });
}

void RadioSim::transmit(std::uint8_t robot) {
    Peer& peer = peers_[robot];
    if (!peer.alive || peer.outgoing.empty() || peer.underWay) return;
    RadioMessage message = peer.outgoing.front();
    message.sequence = peer.sending.of(message.pipe);
    peer.underWay = true;
    const std::uint64_t attempt = ++peer.attempt;
    const bool arrives = carry(wire::Direction::Out, Duration::zero(), [this, robot, attempt, message] {
        RobotRadio* radio = find(robot);
        const bool taken = radio && radio->takeMessage(message);
        attemptEnded(robot, attempt, taken && !medium_.lost());
    });
    if (!arrives) attemptEnded(robot, attempt, false);
}

void RadioSim::attemptEnded(std::uint8_t robot, std::uint64_t attempt, bool acknowledged) {
    Peer& peer = peers_[robot];
    if (!peer.underWay || peer.attempt != attempt) return;
    peer.underWay = false;
    if (acknowledged) {
        peer.failures = 0;
        peer.sending.step(peer.outgoing.front().pipe);
        peer.outgoing.pop_front();
        host_.messageEnded(robot, true);
    } else {
        failed(robot);
    }
    if (pace_ != RadioPace::Ideal || !peer.alive || peer.outgoing.empty()) return;
    flights_.after(acknowledged ? Duration::zero() : kIdealRetry, [this, robot] { transmit(robot); });
}

// ---- Coming and going ----

void RadioSim::discoverNext() {
    for (std::uint8_t i = 1; i <= wire::kRobotCount; ++i) {
        const auto robot = static_cast<std::uint8_t>((lastDiscovered_ + i) % wire::kRobotCount);
        if (peers_[robot].alive) continue;
        lastDiscovered_ = robot;
        // A module takes a repeated frame once, and one that comes after an earlier one did its work is not
        // for a robot that is looked for any more.
        const TimePoint arrival = medium_.arrival(wire::Direction::Out, scheduler_.now());
        if (!medium_.lost()) flights_.at(arrival, [this, robot] { discover(robot); });
        return;
    }
}

void RadioSim::discover(std::uint8_t robot) {
    RobotRadio* radio = find(robot);
    if (!radio || peers_[robot].alive) return;
    radio->discover();
    if (medium_.lost()) return;
    forget(robot);
    peers_[robot].alive = true;
    host_.aliveChanged();
}

void RadioSim::failed(std::uint8_t robot) {
    Peer& peer = peers_[robot];
    if (peer.alive && ++peer.failures >= kFailuresToDrop) drop(robot);
}

void RadioSim::drop(std::uint8_t robot) {
    const std::size_t unsent = peers_[robot].outgoing.size();
    forget(robot);
    for (std::size_t i = 0; i < unsent; ++i)
        host_.messageEnded(robot, false);
    host_.aliveChanged();
}

void RadioSim::forget(std::uint8_t robot) {
    Peer fresh;
    fresh.attempt = peers_[robot].attempt;
    fresh.session = peers_[robot].session + 1;
    peers_[robot] = fresh;
}

}  // namespace kickstand::thunderbots::sim
