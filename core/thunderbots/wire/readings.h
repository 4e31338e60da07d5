#pragma once

#include <cstdint>

#include "core/thunderbots/wire/feedback.h"

namespace kickstand::thunderbots::wire {

/// A reading's value is gain × adc + offset, in its own unit.
struct LinearScale {
    double gain = 1;
    double offset = 0;

    constexpr double value(std::uint16_t adc) const noexcept { return gain * adc + offset; }
    /// The nearest reading of a converter whose highest is `highest_adc`; what lies outside gives its end.
    constexpr std::uint16_t adc(double value, std::uint16_t highest_adc) const noexcept {
        const double raw = (value - offset) / gain + 0.5;
        if (!(raw > 0)) return 0;
        return raw >= highest_adc ? highest_adc : static_cast<std::uint16_t>(raw);
    }
};

/// Battery volts: 10 bits over 3.3 V behind a divider of 1500 and 330 Ω, the middle of each step
/// (protocol 6.2).
inline constexpr LinearScale kBatteryScale_V{3.3 / 330 * 1830 / 1024, 0.5 * 3.3 / 330 * 1830 / 1024};
/// Capacitor volts: 12 bits over 3.3 V behind a divider of 220 kΩ and 2.2 kΩ (protocol 6.3).
inline constexpr LinearScale kCapacitorScale_V{3.3 / 2200 * 222200 / 4096, 0};
/// Dribbler motor degrees Celsius from its thermistor (protocol 6.4).
inline constexpr LinearScale kDribblerScale_C{0.5735, -205.9815};

/// Volts of a reading (protocol 6.2).
constexpr double battery_V(std::uint16_t adc) noexcept {
    return kBatteryScale_V.value(adc);
}
/// Volts of a reading (protocol 6.3).
constexpr double capacitor_V(std::uint16_t adc) noexcept {
    return kCapacitorScale_V.value(adc);
}
/// Degrees Celsius of a reading (protocol 6.4).
constexpr double dribbler_C(std::uint16_t adc) noexcept {
    return kDribblerScale_C.value(adc);
}

/// The other way round, as a robot measures; the nearest reading, held within the converter's range.
constexpr std::uint16_t battery_adc(double volts) noexcept {
    return kBatteryScale_V.adc(volts, kMaxAdc10);
}
/// The reading nearest to these volts, within the converter's range (protocol 6.3).
constexpr std::uint16_t capacitor_adc(double volts) noexcept {
    return kCapacitorScale_V.adc(volts, kMaxAdc12);
}
/// The reading nearest to this temperature, within the converter's range (protocol 6.4).
constexpr std::uint16_t thermistor_adc(double celsius) noexcept {
    return kDribblerScale_C.adc(celsius, kMaxAdc10);
}

/// Below this for a second the robot locks itself out until it is switched off (protocol 6.2).
inline constexpr double kBatteryLockOut_V = 13.0;
/// Marks for a person: below the first the battery is getting low, below the second it is at its end
/// (protocol 6.2).
inline constexpr double kBatteryLow_V = 15.0;
inline constexpr double kBatteryEmpty_V = 14.0;
/// The robot calls its capacitor charged above this (protocol 6.3).
inline constexpr double kCapacitorCharged_V = 215.0;
/// Above this a capacitor is shown as live (protocol 6.3).
inline constexpr double kCapacitorLive_V = 50.0;
/// A deliberate discharge ends here (protocol 6.3).
inline constexpr double kCapacitorDischarged_V = 25.0;
/// The dribbler runs only while its thermistor reads within these, both included (protocol 6.4).
inline constexpr std::uint16_t kThermistorLowest_adc = 200;
inline constexpr std::uint16_t kThermistorHighest_adc = 499;
/// From this reading on there is a ball in the break beam (protocol 6.5).
inline constexpr std::uint16_t kBeamBall_adc = 300;

}  // namespace kickstand::thunderbots::wire
