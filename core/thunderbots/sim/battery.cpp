#include "core/thunderbots/sim/battery.h"

#include <chrono>

#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots::sim {
namespace {

// A lithium polymer pack with its leads and the power switch.
constexpr double kResistance_Ohm = 0.09;
constexpr Duration kLowBeforeLockOut = std::chrono::seconds(1);

}  // namespace

void Battery::setRest(double rest_V) {
    rest_V_ = rest_V;
    terminal_V_ = rest_V_ - load_A_ * kResistance_Ohm;
}

void Battery::step(Duration span, double load_A) {
    load_A_ = load_A;
    terminal_V_ = rest_V_ - load_A_ * kResistance_Ohm;
    low_ = terminal_V_ < wire::kBatteryLockOut_V ? low_ + span : Duration::zero();
    if (low_ >= kLowBeforeLockOut) lockedOut_ = true;
}

void Battery::switchOff() {
    load_A_ = 0;
    terminal_V_ = rest_V_;
    low_ = Duration::zero();
    lockedOut_ = false;
}

}  // namespace kickstand::thunderbots::sim
