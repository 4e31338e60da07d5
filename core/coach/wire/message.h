#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/bytes.h"
#include "core/coach/wire/address.h"

namespace kickstand::coach::wire {

/// Bytes of every message (coach protocol 4).
inline constexpr std::size_t kMessageBytes = 2;
/// The morale at which a crew mutinies, and the one that it has after the mutiny was suppressed (coach
/// protocol 4.3).
inline constexpr int kMutinyMorale = -10;
inline constexpr int kQuelledMorale = -5;

/// What a message is, as it stands in its first byte (coach protocol 4).
enum class Opcode : std::uint8_t {
    SuppressMutiny = 0x00,
    AssertCommand = 0x01,
    Jettison = 0x02,
    Velocity = 0x03,
    FreeDigital = 0x04,
    FreeAnalog = 0x05,
    MutinyInProgress = 0x20,
    Available = 0x21,
    AssertionResult = 0x22,
    UpdateMorale = 0x23,
};

/// A team's color, the parameter of AssertCommand.
enum class TeamColor : std::uint8_t { Red = 0, Blue = 1 };

/// One message: what it is, and its parameter as it stands on the wire.
struct Message {
    Opcode opcode = Opcode::Velocity;
    std::uint8_t parameter = 0;

    friend bool operator==(const Message&, const Message&) = default;
};

/// What a parameter's bits are.
enum class FieldKind : std::uint8_t {
    Unsigned,
    Signed,   ///< Two's complement.
    Level,    ///< A sign bit and a magnitude of three bits, which stands for a percentage.
    Address,  ///< 16 bits, most significant byte first.
    Rssi,     ///< Of −dBm.
};

/// One field: its name, place, range and meaning. Bits count from the most significant of the first byte.
struct FieldSpec {
    const char* name = "";
    FieldKind kind = FieldKind::Unsigned;
    std::uint8_t firstBit = 0;
    std::uint8_t width = 8;
    std::int32_t lowest = 0;
    std::int32_t highest = 0;
    const char* unit = "";
    const char* description = "";
    std::span<const char* const> labels = {};  ///< Names of the values from 0 on, where they have names.
};

/// A message and what is in its parameter; firstBit counts in the parameter.
struct MessageSpec {
    const char* name = "";  ///< "velocity".
    Opcode opcode = Opcode::Velocity;
    Role sender = Role::Coach;
    bool broadcast = false;
    const char* section = "";  ///< Of the protocol reference: "4.2".
    const char* summary = "";
    std::span<const FieldSpec> fields;
};

/// Every message, by opcode. Any thread.
std::span<const MessageSpec> messages() noexcept;
/// The one with that opcode; null where there is none. Any thread.
const MessageSpec* findMessage(std::uint8_t opcode) noexcept;
/// The one with that name; null where there is none. Any thread.
const MessageSpec* findMessage(std::string_view name) noexcept;
/// What is known of a message that was decoded. Any thread.
const MessageSpec& specOf(Opcode opcode) noexcept;

/// A field of `bytes`, which the caller has checked to be long enough. Any thread.
std::int32_t readField(const FieldSpec& field, ByteView bytes) noexcept;
/// Writes it; the caller has checked the value. Any thread.
void writeField(const FieldSpec& field, ByteSpan bytes, std::int32_t value) noexcept;

/// Reads a message; nothing for another length, an opcode that there is none, and a parameter out of its
/// range. Parameters that mean nothing are taken as they are. Any thread.
std::optional<Message> decodeMessage(ByteView bytes) noexcept;
/// The two bytes of a message. Any thread.
constexpr std::array<std::uint8_t, kMessageBytes> encodeMessage(const Message& message) noexcept {
    return {static_cast<std::uint8_t>(message.opcode), message.parameter};
}

}  // namespace kickstand::coach::wire
