#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/bytes.h"
#include "core/framing/bit_field.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// What the bits of a field are.
enum class FieldKind : std::uint8_t {
    Flag,  ///< One bit.
    Unsigned,
    Signed,     ///< Two's complement.
    Opcode,     ///< The one value (`lowest`) by which the kind of message is known.
    Length,     ///< A byte that counts the message it stands in, itself included.
    Bytes,      ///< The rest of the message: `lowest` to `highest` bytes.
    Reserved,   ///< Written as zero, ignored when read, shown when it is not zero.
    FaultCode,  ///< A code of the dongle's error queue (faults.h).
};

/// How a raw number is shown: factor × raw + offset, in `unit`. No unit: the number stands for itself.
struct FieldScale {
    double factor = 1;
    double offset = 0;
    const char* unit = "";
};

/// One field of a message: its name, place, range and meaning. Bits are counted as the message's order says.
struct FieldSpec {
    const char* name = "";
    FieldKind kind = FieldKind::Unsigned;
    std::uint16_t firstBit = 0;
    std::uint8_t width = 0;  ///< Bits; 0 for Bytes.
    std::int32_t lowest = 0;
    std::int32_t highest = 0;
    const char* description = "";
    FieldScale scale = {};
    std::span<const char* const> labels = {};  ///< Names of the values from 0 on, where they have names.
    bool lenient = false;  ///< A value outside the range is read as it is; only writing it is refused.
};

/// What a message's own codec says of bytes, which knows what the fields cannot say one by one, such as data
/// that must stay within its page.
using MessageRule = WireResult<void> (*)(ByteView bytes) noexcept;

/// A message and all its fields, in the order they stand in. The codecs of this folder read and write through
/// these same entries, so that there is one place that says where a bit lives.
struct MessageSpec {
    const char* name = "";  ///< "thunderbots.drive".
    BitOrder order = BitOrder::LsbFirst;
    std::uint8_t minBytes = 0;
    std::uint8_t maxBytes = 0;
    std::uint8_t maxListBytes = 0;  ///< Not 0: a list of such messages, together no longer than this.
    const char* section = "";       ///< Of the protocol reference: "4.1".
    const char* summary = "";
    std::span<const FieldSpec> fields;
    MessageRule mayBeRead = nullptr;  ///< Whether its decoder takes them; never null in messages().
    MessageRule mayBeSent = nullptr;  ///< Whether its encoder makes them (of a list: one item); never null.
};

/// Every message of this system. The variants of one family ("thunderbots.firmware-request.erase") share the
/// name up to the last dot and are told apart by their opcode. Any thread.
std::span<const MessageSpec> messages() noexcept;

/// The message of that full name; null where there is none. Any thread.
const MessageSpec* findMessage(std::string_view name) noexcept;

/// The message of that full name or, for the name of a family, the variant that these bytes are; null where
/// there is none. Any thread.
const MessageSpec* findMessageFor(std::string_view name, ByteView bytes) noexcept;

/// Whether messages() has variants of a family of that name. Any thread.
bool isFamily(std::string_view name) noexcept;

/// The number in a field that is not Bytes. The caller has checked the message's length. Any thread.
std::int32_t readField(const MessageSpec& message, const FieldSpec& field, ByteView bytes) noexcept;
/// Writes it; values outside the field's bits lose their high bits. The caller has checked. Any thread.
void writeField(const MessageSpec& message, const FieldSpec& field, ByteSpan bytes,
                std::int32_t value) noexcept;

}  // namespace kickstand::thunderbots::wire
