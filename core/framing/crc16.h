#pragma once

#include <cstdint>

#include "core/base/bytes.h"

namespace kickstand {

/// The value a CRC-16/MCRF4XX computation starts from; also the CRC of no bytes at all.
inline constexpr std::uint16_t kCrc16Initial = 0xFFFF;

/// CRC-16/MCRF4XX: polynomial 0x1021 reflected, initial value 0xFFFF, reflected in and out, no final XOR
/// (protocol 2.3). Pieces are chained: `crc16(second, crc16(first))` is the CRC of first followed by second.
/// Any thread.
std::uint16_t crc16(ByteView bytes, std::uint16_t soFar = kCrc16Initial) noexcept;

/// crc16() over `count` times the same byte, without a buffer: the padding of an image. Any thread.
std::uint16_t crc16Fill(std::uint8_t byte, std::size_t count, std::uint16_t soFar = kCrc16Initial) noexcept;

}  // namespace kickstand
