#include "core/coach/sim/rival_sim.h"

#include <array>

namespace kickstand::coach::sim {
namespace {

using wire::Opcode;

constexpr Duration kAsk = std::chrono::milliseconds(340);
constexpr int kAsks = 6;
constexpr Duration kSteer = std::chrono::milliseconds(500);
constexpr Duration kSilence = std::chrono::seconds(5);
constexpr Duration kThinks = std::chrono::milliseconds(1200);
constexpr Duration kReply = std::chrono::milliseconds(200);
constexpr std::array<wire::Velocity, 6> kCourse{
    wire::Velocity{4, 0}, {6, 2}, {7, 0}, {3, -5}, {0, 4}, {-2, 0}};
/// So many packets on each part of it.
constexpr std::size_t kLeg = 6;

}  // namespace

RivalSim::RivalSim(Scheduler& scheduler, RadioMedium& medium, wire::Team team, std::uint8_t channel,
                   std::uint16_t pan)
    : SimulatedSide(scheduler, medium, wire::addressOf(wire::Role::Coach, team), channel, pan) {}

void RivalSim::wake() {
    boat_.reset();
    asked_.reset();
    mutinyAt_.reset();
    morale_.reset();
}

void RivalSim::came(std::uint16_t source, const wire::Message& message) {
    if (wire::roleOf(source) != wire::Role::Towrp) return;
    const wire::Team sender = wire::teamOf(source);
    if (message.opcode == Opcode::Available && !boat_ && !asked_) {
        asked_ = sender;
        asks_ = 0;
        askedAt_ = {};
    } else if (message.opcode == Opcode::AssertionResult && asked_ == sender) {
        asked_.reset();
        if (message.parameter != team()) return;
        boat_ = sender;
        repliedAt_ = now();
    } else if (boat_ == sender && message.opcode == Opcode::UpdateMorale) {
        repliedAt_ = now();
        morale_ = static_cast<std::int8_t>(message.parameter);
        if (*morale_ > wire::kMutinyMorale)
            mutinyAt_.reset();
        else if (!mutinyAt_)
            mutinyAt_ = now();
    } else if (boat_ == sender && message.opcode == Opcode::MutinyInProgress && !mutinyAt_) {
        mutinyAt_ = now();
    }
}

void RivalSim::loop(bool slot) {
    if (boat_ && since(repliedAt_, kSilence)) wake();
    if (!slot) return;
    if (asked_ && since(askedAt_, kAsk)) {
        if (++asks_ > kAsks) return asked_.reset();
        askedAt_ = now();
        send(wire::addressOf(wire::Role::Towrp, *asked_), Opcode::AssertCommand, team() % 2);
    } else if (boat_ && mutinyAt_ && since(*mutinyAt_, kThinks) && since(suppressedAt_, kReply)) {
        suppressedAt_ = now();
        send(wire::addressOf(wire::Role::Towrp, *boat_), Opcode::SuppressMutiny, 0);
    } else if (boat_ && since(steeredAt_, kSteer)) {
        steer();
    }
}

void RivalSim::steer() {
    steeredAt_ = now();
    const wire::Velocity velocity = kCourse[course_++ / kLeg % kCourse.size()];
    send(wire::addressOf(wire::Role::Towrp, *boat_), Opcode::Velocity, wire::parameterOf(velocity));
}

}  // namespace kickstand::coach::sim
