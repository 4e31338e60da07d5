#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/framing/inline_bytes.h"

namespace kickstand::smartdevice::wire {

/// What a parameter's value is (protocol 2.3). Raw stands for the bytes of a device that no catalogue knows.
enum class ValueType : std::uint8_t {
    Bool,
    Uint8,
    Int8,
    Uint16,
    Int16,
    Uint32,
    Int32,
    Uint64,
    Int64,
    Float,
    Double,
    Raw,
};
inline constexpr int kValueTypes = 12;

/// No value is wider.
inline constexpr std::size_t kWidestValue = 8;
using RawValue = InlineBytes<kWidestValue>;

/// A value of one of the types, which stand in the order of ValueType.
using Value = std::variant<bool, std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t,
                           std::int32_t, std::uint64_t, std::int64_t, float, double, RawValue>;

inline ValueType typeOf(const Value& value) noexcept {
    return static_cast<ValueType>(value.index());
}
/// "bool", "uint16", "float", …, "raw". Any thread.
const char* name(ValueType type) noexcept;
/// The type of that name; also the C names with "_t". Any thread.
std::optional<ValueType> valueType(std::string_view name) noexcept;
/// Bytes on the wire; 0 for Raw, whose width only the device knows. Any thread.
std::size_t widthOf(ValueType type) noexcept;
/// Whether it has no fraction.
bool isInteger(ValueType type) noexcept;

/// Reads a value, little-endian, of a type and as many bytes as it has; any count up to eight for Raw. A bool
/// is true for any byte that is not zero. Nothing where the count is another. Any thread.
std::optional<Value> readValue(ValueType type, ByteView bytes) noexcept;
/// Appends its bytes. False where there is no room. Any thread.
template <std::size_t capacity>
bool appendValue(InlineBytes<capacity>& bytes, const Value& value) noexcept;
/// The bytes of a value. Any thread.
RawValue bytesOf(const Value& value);

/// The value as a number, for plots and ranges; whole numbers beyond 2^53 are rounded. Nothing for Raw. Any
/// thread.
std::optional<double> toNumber(const Value& value);
/// The value of that type that a number stands for. Nothing where the type cannot hold it: a fraction in a
/// whole number, out of range, not finite, or Raw. Any thread.
std::optional<Value> fromNumber(ValueType type, double number) noexcept;
/// The shortest text that reads as the same value: "true", "-12", "0.5"; hex for Raw. The same in every
/// locale. Any thread.
std::string toText(const Value& value);
/// Reads such a text; a bool also from on, off, 1 and 0, whole numbers also from 0x. Errors: BadArgument with
/// the text, OutOfRange with the bounds where those fit. Any thread.
Result<Value> fromText(ValueType type, std::string_view text, const std::string& subject);

template <std::size_t capacity>
bool appendValue(InlineBytes<capacity>& bytes, const Value& value) noexcept {
    return bytes.append(bytesOf(value).view());
}

}  // namespace kickstand::smartdevice::wire
