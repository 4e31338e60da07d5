#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// Bytes of a message on the kick pipe (protocol 4.4).
inline constexpr std::size_t kKickBytes = 3;
/// One step of kick time (protocol 4.4).
inline constexpr int kKickStep_us = 32;
/// The highest number of steps, and the latest falling edge that exists (protocol 4.4).
inline constexpr int kKickMaxSteps = 127;
inline constexpr int kKickMax_us = kKickMaxSteps * kKickStep_us;

/// A kick as the wire has it (protocol 4.4). The pulse of solenoid k begins at 0 where its flag is set, else
/// at dt, and ends at tk; it is no pulse where that is not later. Times are steps of 32 µs, 0-127.
struct KickTimes {
    bool flag1 = false;
    bool flag2 = false;
    std::uint8_t t1 = 0;
    std::uint8_t t2 = 0;
    std::uint8_t dt = 0;

    friend constexpr bool operator==(const KickTimes&, const KickTimes&) = default;
};

/// Whether a robot takes these autokick times as "disarmed": all three are zero, whatever the flags say
/// (protocol 4.1). Nobody may arm such an autokick.
constexpr bool isNoAutokick(const KickTimes& times) noexcept {
    return times.t1 == 0 && times.t2 == 0 && times.dt == 0;
}

/// The message on the kick pipe (protocol 4.4). Errors: OutOfRange naming t1, t2 or dt past 127. Any thread.
WireResult<std::array<std::uint8_t, kKickBytes>> encodeKick(const KickTimes& times) noexcept;

/// Reads a message of the kick pipe. The reserved bit is ignored, as robots do. Errors: TooShort, TooLong.
/// Any thread.
WireResult<KickTimes> decodeKick(ByteView payload) noexcept;

}  // namespace kickstand::thunderbots::wire
