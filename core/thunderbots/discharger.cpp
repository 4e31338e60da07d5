#include "core/thunderbots/discharger.h"

#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots {
namespace {

/// Long enough for the pulse to reach the robot and for a radio at its true pace to bring the reading back.
constexpr Duration kPulseEvery = std::chrono::milliseconds(50);
/// So many pulses without a lower reading mean that the kicker does not fire.
constexpr int kPulsesWithoutEffect = 60;

}  // namespace

void Discharger::begin(int robot, double capacitor_V, TimePoint now) {
    runs_[static_cast<std::size_t>(robot)] = Run{now, capacitor_V, 0};
}

void Discharger::end(int robot) {
    runs_[static_cast<std::size_t>(robot)].reset();
}

Discharger::Finding Discharger::look(int robot, const RobotState& state, TimePoint now) {
    auto& run = runs_[static_cast<std::size_t>(robot)];
    if (!run) return Finding::Wait;
    if (state.freshness != Freshness::Current) return Finding::Unknown;
    const double capacitor_V = state.readings.capacitor_V;
    if (capacitor_V <= wire::kCapacitorDischarged_V) return Finding::Empty;
    if (capacitor_V < run->lowest_V) {
        run->lowest_V = capacitor_V;
        run->pulsesSinceLower = 0;
    }
    if (run->pulsesSinceLower >= kPulsesWithoutEffect) return Finding::NoEffect;
    return now >= run->nextPulse ? Finding::Pulse : Finding::Wait;
}

void Discharger::pulsed(int robot, TimePoint now) {
    auto& run = runs_[static_cast<std::size_t>(robot)];
    if (!run) return;
    run->nextPulse = now + kPulseEvery;
    ++run->pulsesSinceLower;
}

}  // namespace kickstand::thunderbots
