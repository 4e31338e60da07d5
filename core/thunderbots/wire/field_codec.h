#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/thunderbots/wire/fields.h"

namespace kickstand::thunderbots::wire {

/// Short forms in which the field tables are written (layout_*.h).
namespace layout {

constexpr FieldSpec flag(const char* name, std::uint16_t bit, const char* description) {
    return {name, FieldKind::Flag, bit, 1, 0, 1, description};
}
constexpr FieldSpec number(const char* name, std::uint16_t firstBit, std::uint8_t width, std::int32_t lowest,
                           std::int32_t highest, const char* description, FieldScale scale = {}) {
    const FieldKind kind = lowest < 0 ? FieldKind::Signed : FieldKind::Unsigned;
    return {name, kind, firstBit, width, lowest, highest, description, scale};
}
constexpr FieldSpec choice(const char* name, std::uint16_t firstBit, std::uint8_t width,
                           std::span<const char* const> labels, const char* description) {
    const auto highest = static_cast<std::int32_t>(labels.size()) - 1;
    return {name, FieldKind::Unsigned, firstBit, width, 0, highest, description, {}, labels};
}
/// What a robot may hold although it should not.
constexpr FieldSpec lenient(FieldSpec field) {
    field.lenient = true;
    return field;
}
constexpr FieldSpec opcode(std::int32_t value) {
    return {"opcode", FieldKind::Opcode, 0, 8, value, value, "Which request or response this is"};
}
constexpr FieldSpec bytes(const char* name, std::uint16_t firstBit, std::int32_t fewest, std::int32_t most,
                          const char* description) {
    return {name, FieldKind::Bytes, firstBit, 0, fewest, most, description};
}
constexpr FieldSpec reserved(const char* name, std::uint16_t firstBit, std::uint8_t width) {
    const std::int32_t highest = (1 << width) - 1;
    return {name, FieldKind::Reserved, firstBit, width, 0, highest, "Reserved: zero"};
}

}  // namespace layout

constexpr WireError fault(WireFault kind, const FieldSpec& field, std::int32_t got) noexcept {
    return {kind, field.name, field.lowest, field.highest, got};
}

/// What is wrong with a length, if anything is.
constexpr std::optional<WireError> lengthFault(std::size_t length, std::size_t fewest,
                                               std::size_t most) noexcept {
    if (length >= fewest && length <= most) return std::nullopt;
    return WireError{length < fewest ? WireFault::TooShort : WireFault::TooLong, "length",
                     static_cast<std::int32_t>(fewest), static_cast<std::int32_t>(most),
                     static_cast<std::int32_t>(length)};
}

/// Reads the fields of one message whose length has been checked, and remembers the first value out of range.
template <BitOrder order>
class FieldReader {
  public:
    constexpr explicit FieldReader(ByteView bytes) noexcept : bytes_(bytes) {}

    constexpr std::int32_t number(const FieldSpec& field) noexcept {
        const std::uint32_t raw = readBits<order>(bytes_, field.firstBit, field.width);
        const std::int32_t value =
            field.kind == FieldKind::Signed ? signExtend(raw, field.width) : static_cast<std::int32_t>(raw);
        const bool legal = value >= field.lowest && value <= field.highest;
        if (!legal && !field.lenient) remember(fault(WireFault::BadValue, field, value));
        return value;
    }
    constexpr bool flag(const FieldSpec& field) noexcept { return number(field) != 0; }
    constexpr std::uint8_t byte(const FieldSpec& field) noexcept {
        return static_cast<std::uint8_t>(number(field));
    }
    constexpr std::uint16_t word(const FieldSpec& field) noexcept {
        return static_cast<std::uint16_t>(number(field));
    }

    /// `value`, unless a field was wrong.
    template <class T>
    constexpr WireResult<T> result(T value) const noexcept {
        if (failed_) return tl::unexpected(error_);
        return value;
    }

  private:
    constexpr void remember(const WireError& error) noexcept {
        if (failed_) return;
        failed_ = true;
        error_ = error;
    }

    ByteView bytes_;
    WireError error_;
    bool failed_ = false;
};

/// Writes the fields of one message whose length has been made, and remembers the first value out of range.
template <BitOrder order>
class FieldWriter {
  public:
    constexpr explicit FieldWriter(ByteSpan bytes) noexcept : bytes_(bytes) {}

    constexpr void number(const FieldSpec& field, std::int32_t value) noexcept {
        const bool legal = value >= field.lowest && value <= field.highest;
        if (!legal) remember(fault(WireFault::OutOfRange, field, value));
        put(field, value);
    }
    /// The same for a value that is kept as it came, legal or not.
    constexpr void put(const FieldSpec& field, std::int32_t value) noexcept {
        writeBits<order>(bytes_, field.firstBit, field.width, static_cast<std::uint32_t>(value));
    }

    /// `message`, unless a field was wrong.
    template <class T>
    constexpr WireResult<T> result(const T& message) const noexcept {
        if (failed_) return tl::unexpected(error_);
        return message;
    }

  private:
    constexpr void remember(const WireError& error) noexcept {
        if (failed_) return;
        failed_ = true;
        error_ = error;
    }

    ByteSpan bytes_;
    WireError error_;
    bool failed_ = false;
};

}  // namespace kickstand::thunderbots::wire
