#include "core/thunderbots/sim/capacitor.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots::sim {
namespace {

using std::chrono::milliseconds;

// Energy is proportional to the square of the voltage: the charger adds this much of it a second. From 148 V,
// where a full kick leaves the bank, it is back at 219 V in 1.9 s.
constexpr double kChargeRate_V2perS = (219.0 * 219.0 - 148.0 * 148.0) / 1.9;
// A pulse of 2.4 ms takes 219 V down to 148 V.
constexpr double kSolenoid_s = 6.125e-3;
constexpr double kLeak_s = 900;
constexpr Duration kLongestCharge = std::chrono::seconds(8);
constexpr Duration kPulseTime = milliseconds(100);

}  // namespace

void Capacitor::step(Duration span, bool chargerOn) {
    const Duration paused = std::min(span, pause_);
    pause_ -= paused;
    leak(paused);
    span -= paused;
    if (!chargerOn) {
        charging_ = false;
        timedOut_ = false;
        cycle_ = Duration::zero();
        leak(span);
        return;
    }
    if (pause_ > Duration::zero() || timedOut_) {
        leak(span);
        return;
    }
    if (volts_ < kRestart_V) charging_ = true;
    charge(span);
}

void Capacitor::charge(Duration span) {
    if (charging_) {
        const Duration needed = fromSeconds((kFull_V * kFull_V - volts_ * volts_) / kChargeRate_V2perS);
        const Duration used = std::clamp(needed, Duration::zero(), span);
        volts_ = std::sqrt(volts_ * volts_ + kChargeRate_V2perS * seconds(used));
        total_ += used;
        cycle_ += used;
        span -= used;
        if (used == needed || needed <= Duration::zero()) {
            charging_ = false;
            cycle_ = Duration::zero();
        } else if (cycle_ >= kLongestCharge) {
            charging_ = false;
            timedOut_ = true;
        }
    }
    const bool regulating = volts_ >= kRestart_V;
    leak(span);
    if (regulating) volts_ = std::max(volts_, kRestart_V);
}

void Capacitor::leak(Duration span) {
    if (span > Duration::zero()) volts_ *= std::exp(-seconds(span) / kLeak_s);
}

void Capacitor::discharge(Duration on, Duration busy) {
    volts_ *= std::exp(-seconds(on) / kSolenoid_s);
    pause_ = std::max(pause_, busy);
    charging_ = false;
    cycle_ = Duration::zero();
}

bool Capacitor::charged() const {
    return volts_ > wire::kCapacitorCharged_V;
}

std::uint32_t Capacitor::chargePulses() const {
    return static_cast<std::uint32_t>(total_ / kPulseTime);
}

}  // namespace kickstand::thunderbots::sim
