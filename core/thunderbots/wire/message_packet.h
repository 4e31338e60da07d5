#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"
#include "core/framing/inline_bytes.h"
#include "core/thunderbots/wire/pipes.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// A message packet is a header byte and a payload (protocol 3.7).
inline constexpr std::size_t kMaxMessagePayload = 63;
inline constexpr std::size_t kMaxMessagePacket = 1 + kMaxMessagePayload;

using MessagePayload = InlineBytes<kMaxMessagePayload>;
using MessagePacket = InlineBytes<kMaxMessagePacket>;

/// A message packet that was read. `payload` points into the bytes it was read from.
struct MessageView {
    std::uint8_t robot = 0;
    Pipe pipe = Pipe::Kick;
    ByteView payload;
};

/// A packet for endpoint 0x06 or 0x86 (protocol 3.7). Errors: OutOfRange naming robot; UnknownKind naming
/// pipe where it is no message pipe; TooLong for more than 63 bytes of payload. Any thread.
WireResult<MessagePacket> encodeMessagePacket(std::uint8_t robot, Pipe pipe, ByteView payload) noexcept;

/// Reads a packet that went in `direction`. Errors: TooShort for no byte at all, TooLong past 64, UnknownKind
/// for a pipe that carries no messages that way. Any thread.
WireResult<MessageView> decodeMessagePacket(ByteView packet, Direction direction) noexcept;

}  // namespace kickstand::thunderbots::wire
