#include <algorithm>
#include <chrono>

#include "core/thunderbots/sim/radio_sim.h"
#include "core/thunderbots/wire/micropacket.h"

namespace kickstand::thunderbots::sim {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr Duration kIdealPeriod = milliseconds(5);
// Ten bits a byte at 250,000 baud.
constexpr Duration kByteTime = microseconds(40);
// Until the module reports how a unicast went.
constexpr Duration kStatusTime = milliseconds(1);
// Between two cycles: a polled robot begins its answer.
constexpr Duration kGapTime = microseconds(600);
constexpr std::size_t kBroadcastRobots = 8;
// The poll byte; the pipe and sequence number of a message; the byte of a discovery (protocol 5.2-5.4).
constexpr std::size_t kPollBytes = 1;
constexpr std::size_t kMessageHeaderBytes = 2;
constexpr std::size_t kDiscoveryBytes = 1;

}  // namespace

void RadioSim::idealTick() {
    expirePolls();
    for (std::uint8_t robot = 0; robot < wire::kRobotCount; ++robot) {
        if (!peers_[robot].alive) continue;
        broadcast(robot);
        if (!peers_[robot].polled) poll(robot);
    }
    discoverNext();
    if (running_) step_.start(kIdealPeriod, [this] { idealTick(); });
}

Duration RadioSim::airTime(std::size_t bytes) const {
    if (pace_ == RadioPace::Ideal) return Duration::zero();
    return kByteTime * static_cast<std::int64_t>(kRadioFrameBytes + bytes);
}

void RadioSim::beginPhase() {
    if (!running_) return;
    Duration time = phaseTime();
    // A phase without anything to send takes no time; the gap at the end always does.
    while (time == Duration::zero()) {
        phase_ = static_cast<Phase>(static_cast<int>(phase_) + 1);
        time = phaseTime();
    }
    step_.start(time, [this] {
        endPhase();
        beginPhase();
    });
}

Duration RadioSim::phaseTime() {
    const auto broadcastTime = [this](std::size_t robots) {
        return robots == 0 ? Duration::zero() : airTime(kPollBytes + robots * wire::kDriveMicropacketBytes);
    };
    switch (phase_) {
        case Phase::FirstBroadcast:
            cycleRobots_.clear();
            messageTurn_ = 0;
            for (std::uint8_t robot = 0; robot < wire::kRobotCount; ++robot) {
                if (peers_[robot].alive) cycleRobots_.push_back(robot);
            }
            return broadcastTime(std::min(cycleRobots_.size(), kBroadcastRobots));
        case Phase::SecondBroadcast:
            return broadcastTime(cycleRobots_.size() - std::min(cycleRobots_.size(), kBroadcastRobots));
        case Phase::Messages:
            if (!findMessage()) return Duration::zero();
            return airTime(kMessageHeaderBytes + peers_[messageTurn_].outgoing.front().payload.size()) +
                   kStatusTime;
        case Phase::Discovery:
            return alive() == 0xFFFF ? Duration::zero() : airTime(kDiscoveryBytes) + kStatusTime;
        case Phase::Gap:
            break;
    }
    return kGapTime;
}

void RadioSim::endPhase() {
    switch (phase_) {
        case Phase::FirstBroadcast:
            broadcastPart(0);
            pollNext();
            phase_ = Phase::SecondBroadcast;
            break;
        case Phase::SecondBroadcast:
            broadcastPart(kBroadcastRobots);
            phase_ = Phase::Messages;
            break;
        case Phase::Messages:
            // The phase goes on until every robot had its turn.
            transmit(messageTurn_++);
            break;
        case Phase::Discovery:
            discoverNext();
            phase_ = Phase::Gap;
            break;
        case Phase::Gap:
            expirePolls();
            phase_ = Phase::FirstBroadcast;
            break;
    }
}

void RadioSim::broadcastPart(std::size_t first) {
    const std::size_t end = std::min(cycleRobots_.size(), first + kBroadcastRobots);
    for (std::size_t i = first; i < end; ++i) {
        if (peers_[cycleRobots_[i]].alive) broadcast(cycleRobots_[i]);
    }
}

void RadioSim::pollNext() {
    const bool waiting =
        std::ranges::any_of(peers_, [](const Peer& peer) { return peer.polled.has_value(); });
    if (waiting) return;
    for (std::uint8_t i = 1; i <= wire::kRobotCount; ++i) {
        const auto robot = static_cast<std::uint8_t>((lastPolled_ + i) % wire::kRobotCount);
        if (!peers_[robot].alive) continue;
        lastPolled_ = robot;
        return poll(robot);
    }
}

bool RadioSim::findMessage() {
    for (; messageTurn_ < peers_.size(); ++messageTurn_) {
        const Peer& peer = peers_[messageTurn_];
        if (peer.alive && !peer.outgoing.empty() && !peer.underWay) return true;
    }
    return false;
}

}  // namespace kickstand::thunderbots::sim
