#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kickstand {

/// Bytes that are only looked at. Never owned: valid as long as what they point into.
using ByteView = std::span<const std::uint8_t>;
/// Bytes that are written into.
using ByteSpan = std::span<std::uint8_t>;

// Loads and stores of whole numbers at `offset`, little-endian (Le) or big-endian (Be); the caller has
// checked the bounds. Any thread.

constexpr std::uint16_t loadLe16(ByteView bytes, std::size_t offset) {
    return static_cast<std::uint16_t>(bytes[offset] | bytes[offset + 1] << 8);
}
constexpr std::uint32_t loadLe24(ByteView bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[offset + 2]) << 16;
}
constexpr void storeLe16(ByteSpan bytes, std::size_t offset, std::uint16_t value) {
    bytes[offset] = static_cast<std::uint8_t>(value);
    bytes[offset + 1] = static_cast<std::uint8_t>(value >> 8);
}
constexpr void storeLe24(ByteSpan bytes, std::size_t offset, std::uint32_t value) {
    bytes[offset] = static_cast<std::uint8_t>(value);
    bytes[offset + 1] = static_cast<std::uint8_t>(value >> 8);
    bytes[offset + 2] = static_cast<std::uint8_t>(value >> 16);
}
constexpr std::uint16_t loadBe16(ByteView bytes, std::size_t offset) {
    return static_cast<std::uint16_t>(bytes[offset] << 8 | bytes[offset + 1]);
}
constexpr std::uint32_t loadBe32(ByteView bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(loadBe16(bytes, offset)) << 16 | loadBe16(bytes, offset + 2);
}
constexpr void storeBe16(ByteSpan bytes, std::size_t offset, std::uint16_t value) {
    bytes[offset] = static_cast<std::uint8_t>(value >> 8);
    bytes[offset + 1] = static_cast<std::uint8_t>(value);
}
constexpr void storeBe32(ByteSpan bytes, std::size_t offset, std::uint32_t value) {
    storeBe16(bytes, offset, static_cast<std::uint16_t>(value >> 16));
    storeBe16(bytes, offset + 2, static_cast<std::uint16_t>(value));
}

}  // namespace kickstand
