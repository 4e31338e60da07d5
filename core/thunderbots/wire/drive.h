#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"
#include "core/thunderbots/wire/kick.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// Bytes of a drive block: 79 bits and a zero bit (protocol 4.1).
inline constexpr std::size_t kDriveBytes = 10;
/// The highest wheel speed either way (protocol 4.1). −1024 fits the field and is not legal.
inline constexpr std::int16_t kMaxWheel = 1023;
inline constexpr std::size_t kWheelCount = 4;

/// What a robot is told over and over (protocol 4.1). The default is a braked robot with everything off,
/// which is all zeros on the wire.
struct DriveBlock {
    bool run = false;      ///< Motors run; false: they brake.
    bool charge = false;   ///< Capacitor charger.
    bool dribble = false;  ///< Dribbler.
    bool autokickArmed = false;
    KickTimes autokick{};  ///< The kick that a ball in the beam sets off.
    /// Wheels 1-4, −1023 to 1023 quarter-degrees per 5 ms.
    std::array<std::int16_t, kWheelCount> wheels{};
    std::uint8_t testClass = 0;   ///< 0-7, as in TestClass; not 0: shown while it is sent (protocol 4.2).
    std::uint8_t testTarget = 0;  ///< 0-7.

    friend constexpr bool operator==(const DriveBlock&, const DriveBlock&) = default;
};

/// The block that stops a robot: wheels braked, charger, dribbler, autokick and test off.
constexpr DriveBlock brakedBlock() noexcept {
    return {};
}

/// The drive block's bytes (protocol 4.1, 2.2). Reserved bits are written as zero. Errors: OutOfRange naming
/// the first field that is: a wheel (−1024 included), test_class or test_target past 7, a time past 127. Any
/// thread.
WireResult<std::array<std::uint8_t, kDriveBytes>> encodeDrive(const DriveBlock& block) noexcept;

/// Reads a drive block. Reserved bits are ignored, as robots do; hasReservedDriveBits() tells of them.
/// Errors: TooShort, TooLong, BadValue naming a wheel at −1024. Any thread.
WireResult<DriveBlock> decodeDrive(ByteView payload) noexcept;

/// Whether a bit that the protocol reserves is set in these ten bytes: nothing that this project sends. False
/// for any other length. Any thread.
bool hasReservedDriveBits(ByteView payload) noexcept;

}  // namespace kickstand::thunderbots::wire
