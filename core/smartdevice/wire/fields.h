#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/smartdevice/wire/message.h"

namespace kickstand::smartdevice::wire {

/// What the bytes of a field are.
enum class FieldKind : std::uint8_t {
    Number,  ///< Little-endian, unsigned.
    Mask,    ///< A number of which each bit is a parameter.
    Uid,
    Values,  ///< The rest of the payload.
    Code,    ///< An ErrorCode.
};

/// One field of a payload, behind the one before it: its width, unit, range and meaning.
struct FieldSpec {
    const char* name = "";
    FieldKind kind = FieldKind::Number;
    std::array<std::uint8_t, 2> bytes{};  ///< In each Dialect; 0 for Values, which take what is left.
    const char* unit = "";
    const char* description = "";
    std::array<std::int64_t, 2> highest{};  ///< In each Dialect, from 0 on; 0 for what is no number.
};

/// Who sends a message.
enum class Direction : std::uint8_t { ToDevice, ToHost, Both };

/// A message and the fields of its payload, in the order they stand in.
struct MessageSpec {
    MessageId id = MessageId::Ping;
    const char* name = "";
    Direction direction = Direction::ToDevice;
    const char* section = "";  ///< Of the protocol reference: "3.1".
    const char* summary = "";
    std::span<const FieldSpec> fields;
};

/// Every message there is, by ascending ID. Any thread.
std::span<const MessageSpec> messages() noexcept;
/// Null for a number that is no message. Any thread.
const MessageSpec* messageSpec(MessageId id) noexcept;

/// How long a payload may be.
struct PayloadBounds {
    std::size_t least = 0;
    std::size_t most = 0;
};
PayloadBounds payloadBounds(const MessageSpec& message, Dialect dialect) noexcept;

}  // namespace kickstand::smartdevice::wire
