#include "core/thunderbots/sim/dribbler.h"

#include <cmath>

#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots::sim {
namespace {

constexpr double kThermal_s = 120;
// How far above its surroundings it would get at full duty.
constexpr double kRise_C = 90;
constexpr double kFullSpeed = 600;

}  // namespace

void Dribbler::step(Duration span, bool on, std::uint8_t duty) {
    const std::uint16_t reading = thermistor_adc();
    running_ = on && reading >= wire::kThermistorLowest_adc && reading <= wire::kThermistorHighest_adc;
    const double part = running_ ? duty / 255.0 : 0;
    const double target_C = kAmbient_C + kRise_C * part * part;
    temperature_C_ = target_C + (temperature_C_ - target_C) * std::exp(-seconds(span) / kThermal_s);
    motor_.step(span, kFullSpeed * part, running_);
}

std::uint16_t Dribbler::thermistor_adc() const {
    return wire::thermistor_adc(temperature_C_);
}

}  // namespace kickstand::thunderbots::sim
