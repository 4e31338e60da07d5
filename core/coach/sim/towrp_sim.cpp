#include "core/coach/sim/towrp_sim.h"

#include <algorithm>

namespace kickstand::coach::sim {
namespace {

using wire::Opcode;

constexpr Duration kMutiny = std::chrono::seconds(3);
constexpr Duration kSecond = std::chrono::seconds(1);
constexpr Duration kSilence = std::chrono::seconds(5);
/// Well within the second that the protocol asks for.
constexpr Duration kAvailable = std::chrono::milliseconds(500);
constexpr Duration kMutinyToldEvery = std::chrono::milliseconds(800);

}  // namespace

TowrpSim::TowrpSim(Scheduler& scheduler, RadioMedium& medium, wire::Team team, std::uint8_t channel,
                   std::uint16_t pan, CrewOptions crew)
    : SimulatedSide(scheduler, medium, wire::addressOf(wire::Role::Towrp, team), channel, pan), crew_(crew) {}

void TowrpSim::wake() {
    coach_.reset();
    velocity_ = {};
    morale_ = 0;
    mutinyAt_.reset();
    result_ = reply_ = false;
    availableAt_ = {};
}

void TowrpSim::setMorale(int morale) {
    if (!coach_ || mutinyAt_) return;
    morale_ = std::clamp(morale, wire::kMutinyMorale, 127);
    moraleAt_ = now();
    if (morale_ == wire::kMutinyMorale) mutinyAt_ = now();
}

void TowrpSim::came(std::uint16_t source, const wire::Message& message) {
    if (wire::roleOf(source) != wire::Role::Coach) return;
    const wire::Team sender = wire::teamOf(source);
    if (coach_ && sender != *coach_) return;
    if (message.opcode == Opcode::AssertCommand) {
        result_ = true;
        if (!coach_) velocityAt_ = moraleAt_ = now();
        coach_ = sender;
    } else if (coach_) {
        obey(message);
    }
}

void TowrpSim::obey(const wire::Message& message) {
    switch (message.opcode) {
        case Opcode::Velocity:
            velocity_ = wire::velocityOf(message.parameter);
            velocityAt_ = now();
            ++velocities_;
            reply_ = true;
            break;
        case Opcode::SuppressMutiny:
            if (mutinyAt_) morale_ = wire::kQuelledMorale;
            mutinyAt_.reset();
            moraleAt_ = now();
            reply_ = true;
            break;
        case Opcode::Jettison:
            wake();
            break;
        case Opcode::FreeDigital:
            ++freeDigital_;
            break;
        case Opcode::FreeAnalog:
            freeAnalog_ = static_cast<std::int8_t>(message.parameter);
            break;
        default:
            break;
    }
}

void TowrpSim::timers() {
    if (!coach_) return;
    if (since(velocityAt_, kSecond)) velocity_ = {};
    if (since(velocityAt_, kSilence) || (mutinyAt_ && since(*mutinyAt_, kMutiny))) return wake();
    if (crew_.fall > Duration::zero() && !mutinyAt_ && since(moraleAt_, crew_.fall)) setMorale(morale_ - 1);
}

void TowrpSim::loop(bool slot) {
    timers();
    if (!slot) return;
    const std::uint16_t coach = coach_ ? wire::addressOf(wire::Role::Coach, *coach_) : std::uint16_t{0};
    if (result_) {
        result_ = false;
        send(xbee::kBroadcast, Opcode::AssertionResult, *coach_);
    } else if (reply_ && !(mutinyAt_ && since(mutinyToldAt_, kMutinyToldEvery))) {
        reply_ = false;
        send(coach, Opcode::UpdateMorale, static_cast<std::uint8_t>(morale_));
    } else if (mutinyAt_) {
        mutinyToldAt_ = now();
        send(coach, Opcode::MutinyInProgress, 0);
    } else if (!coach_ && since(availableAt_, kAvailable)) {
        availableAt_ = now();
        send(xbee::kBroadcast, Opcode::Available, 0);
    }
}

}  // namespace kickstand::coach::sim
