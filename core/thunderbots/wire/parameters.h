#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"
#include "core/framing/inline_bytes.h"
#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// Radio channels that exist; 0 in the block means that none is configured (protocol 3.3, 4.8).
inline constexpr std::uint8_t kLowestChannel = 0x0B;
inline constexpr std::uint8_t kHighestChannel = 0x1A;

/// Bytes of the operational parameters block that the protocol defines, and the most that a message can carry
/// (protocol 4.8).
inline constexpr std::size_t kDefinedParameterBytes = 5;
inline constexpr std::size_t kMaxParameterBytes = kMaxMessagePayload - 1;

/// What the robot's SPI flash holds (protocol 4.8). Any other value means no data.
enum class FlashContents : std::uint8_t { FpgaBitstream = 0, Microcontroller = 1, NoData = 0xFF };

/// The operational parameters block (protocol 4.8). Values are kept as the robot has them, legal or not, so
/// that a damaged block can be shown and mended; checkParameters() judges them.
struct OperationalParameters {
    std::uint8_t flashContents = 0xFF;  ///< As FlashContents.
    std::uint8_t channel0 = 0;          ///< 0x0B-0x1A, or 0: not configured.
    std::uint8_t channel1 = 0;
    std::uint8_t robotNumber = 0;   ///< 0-15.
    std::uint8_t dribblerDuty = 0;  ///< 0-255: the dribbler's PWM duty while it is on.
    /// What the robot has behind the bytes that are defined: kept as it was read and written back unchanged.
    InlineBytes<kMaxParameterBytes - kDefinedParameterBytes> tail;

    /// The flash contents by name; a number without one is given as it is (protocol 4.8).
    FlashContents flash() const noexcept {
        return flashContents > 1 ? FlashContents::NoData : static_cast<FlashContents>(flashContents);
    }
    friend constexpr bool operator==(const OperationalParameters&, const OperationalParameters&) = default;
};

using ParameterBytes = InlineBytes<kMaxParameterBytes>;

/// The block's bytes, as long as the block that was read (protocol 4.8). Any thread.
ParameterBytes encodeParameters(const OperationalParameters& parameters) noexcept;

/// Reads a block of any length from 5 to 62 bytes. Errors: TooShort, TooLong. Any thread.
WireResult<OperationalParameters> decodeParameters(ByteView block) noexcept;

/// Whether a robot can live with these values. Errors: OutOfRange naming channel0, channel1 or robot_number.
/// Any thread.
WireResult<void> checkParameters(const OperationalParameters& parameters) noexcept;

}  // namespace kickstand::thunderbots::wire
