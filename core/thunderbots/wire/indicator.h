#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "core/base/bytes.h"
#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// The buffer that experiment data describes, in pieces (protocol 4.6).
inline constexpr std::size_t kExperimentBufferBytes = 256;
inline constexpr std::size_t kExperimentPieceBytes = 32;
inline constexpr std::uint8_t kExperimentMaxOffset = kExperimentBufferBytes - kExperimentPieceBytes;

/// The robot fired its autokick (protocol 4.6): a message without payload.
struct AutokickFired {
    friend constexpr bool operator==(const AutokickFired&, const AutokickFired&) = default;
};

/// A piece of a robot's experiment buffer (protocol 4.6).
struct ExperimentData {
    std::uint8_t offset = 0;  ///< Where the piece belongs: 0-224.
    std::array<std::uint8_t, kExperimentPieceBytes> data{};

    friend constexpr bool operator==(const ExperimentData&, const ExperimentData&) = default;
};

/// What pipe 6 carries; the two are told apart by their length (protocol 4.6).
using IndicatorMessage = std::variant<AutokickFired, ExperimentData>;

/// The message's bytes. Errors: OutOfRange for an offset past 224. Any thread.
WireResult<MessagePayload> encodeIndicator(const IndicatorMessage& message) noexcept;

/// Reads a message of pipe 6. Errors: BadLength for anything but 0 or 33 bytes, BadValue for an offset past
/// 224. Any thread.
WireResult<IndicatorMessage> decodeIndicator(ByteView payload) noexcept;

}  // namespace kickstand::thunderbots::wire
