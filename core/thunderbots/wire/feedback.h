#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// Bytes of a feedback block (protocol 4.3).
inline constexpr std::size_t kFeedbackBytes = 9;
/// The highest readings of the robot's converters (protocol 4.3).
inline constexpr std::uint16_t kMaxAdc10 = 1023;
inline constexpr std::uint16_t kMaxAdc12 = 4095;

/// What a robot says of itself (protocol 4.3). With `valid` false every other member is unknown, not zero.
/// readings.h turns the raw readings into volts and degrees.
struct FeedbackBlock {
    bool valid = false;
    bool ball = false;                 ///< Ball in the break beam.
    bool ballLoad = false;             ///< Ball loading the dribbler; robots of the time never set it.
    bool charged = false;              ///< Capacitor charged.
    std::uint16_t battery_adc = 0;     ///< 0-1023.
    std::uint16_t capacitor_adc = 0;   ///< 0-4095.
    std::uint16_t thermistor_adc = 0;  ///< 0-1023.
    std::uint16_t light_adc = 0;       ///< 0-1023: the break beam's sensor.

    friend constexpr bool operator==(const FeedbackBlock&, const FeedbackBlock&) = default;
};

/// The feedback block's bytes (protocol 4.3). Errors: OutOfRange naming the reading. Any thread.
WireResult<std::array<std::uint8_t, kFeedbackBytes>> encodeFeedback(const FeedbackBlock& block) noexcept;

/// Reads a feedback block. Reserved flag bits are ignored. Errors: TooShort, TooLong, BadValue naming a
/// reading that its converter cannot give. Any thread.
WireResult<FeedbackBlock> decodeFeedback(ByteView payload) noexcept;

}  // namespace kickstand::thunderbots::wire
