#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include "core/base/error.h"
#include "core/thunderbots/wire/kick.h"

namespace kickstand::thunderbots::wire {

/// A kick in a person's terms (protocol 4.4): how long each solenoid is on, and how much later solenoid 2
/// begins than solenoid 1; negative: solenoid 1 begins later. A width of 0 is no pulse, and then there is no
/// offset either: it is 0.
struct KickPulses {
    int width1_us = 0;
    int width2_us = 0;
    int offset_us = 0;

    friend constexpr bool operator==(const KickPulses&, const KickPulses&) = default;
};

/// What a person's terms became on the wire.
struct KickEncoding {
    KickTimes times;
    KickPulses sent;  ///< What the robot will do: on the 32 µs grid, the offset 0 where a pulse is missing.
    bool snapped = false;  ///< Whether `sent` is not what was asked for.

    friend constexpr bool operator==(const KickEncoding&, const KickEncoding&) = default;
};

/// Why a kick cannot be put on the wire.
struct KickTimingError {
    enum class Reason : std::uint8_t {
        NegativeWidth,  ///< `at_us` is the width.
        EdgeTooLate,    ///< The falling edge would be at `at_us`, `excess_us` past the last one that exists.
    };
    Reason reason = Reason::EdgeTooLate;
    int solenoid = 1;  ///< 1 or 2.
    std::int64_t at_us = 0;
    std::int64_t excess_us = 0;
};

/// Finds the wire's times for a person's terms (protocol 4.4). Each value goes to the nearest step of 32 µs,
/// the half-way ones towards zero: so what fits before snapping fits after it. With no offset both flags are
/// set and dt is 0; otherwise the later solenoid's flag is clear and dt is the delay. Nothing is ever
/// clipped: a falling edge that was asked for past 4064 µs is an error. Any thread.
tl::expected<KickEncoding, KickTimingError> encodePulses(const KickPulses& asked) noexcept;

/// The pulse of one solenoid, counted from the moment of the kick. Its falling edge is at start + width.
struct Pulse {
    int start_us = 0;
    int width_us = 0;  ///< 0: no pulse; then `start_us` is 0 too.

    friend constexpr bool operator==(const Pulse&, const Pulse&) = default;
};

/// What a robot does with these times, solenoid 1 first (protocol 4.4). Any thread.
std::array<Pulse, 2> pulsesOf(const KickTimes& times) noexcept;

/// The same in a person's terms. A delay that both pulses share says nothing about either width or the offset
/// and is not kept. Any thread.
KickPulses personTermsOf(const KickTimes& times) noexcept;

/// The facts for the world outside: NoEncoding for an edge too late (subject "solenoid 1" or "solenoid 2",
/// highest 4064, got the edge in µs), OutOfRange for a negative width. Allocates. Any thread.
Error toError(const KickTimingError& error);

}  // namespace kickstand::thunderbots::wire
