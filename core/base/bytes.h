#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kickstand {

/// Bytes that are only looked at. Never owned: valid as long as what they point into.
using ByteView = std::span<const std::uint8_t>;
/// Bytes that are written into.
using ByteSpan = std::span<std::uint8_t>;

/// Little-endian loads and stores at `offset`; the caller has checked the bounds.
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

}  // namespace kickstand
