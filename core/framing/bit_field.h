#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"

namespace kickstand {

/// How the bits of a message are counted.
enum class BitOrder : std::uint8_t {
    MsbFirst,  ///< Bit 0 is the most significant bit of byte 0; a field's most significant bit comes first.
    LsbFirst,  ///< Bit 0 is the least significant bit of byte 0; whole bytes make little-endian numbers.
};

/// The widest field that readBits() and writeBits() take.
inline constexpr unsigned kMaxFieldBits = 32;

/// The unsigned number in `width` bits (1-32) from `firstBit`. The caller has checked that they lie in
/// `bytes`. Any thread.
template <BitOrder order>
constexpr std::uint32_t readBits(ByteView bytes, std::size_t firstBit, unsigned width) noexcept {
    const std::size_t firstByte = firstBit / 8;
    const std::size_t lastByte = (firstBit + width - 1) / 8;
    const auto mask = (std::uint64_t{1} << width) - 1;
    std::uint64_t window = 0;
    if constexpr (order == BitOrder::MsbFirst) {
        for (std::size_t i = firstByte; i <= lastByte; ++i)
            window = window << 8 | bytes[i];
        return static_cast<std::uint32_t>(window >> ((lastByte + 1) * 8 - firstBit - width) & mask);
    } else {
        for (std::size_t i = lastByte + 1; i > firstByte; --i)
            window = window << 8 | bytes[i - 1];
        return static_cast<std::uint32_t>(window >> (firstBit % 8) & mask);
    }
}

/// Writes the low `width` bits (1-32) of `value` from `firstBit` and leaves every other bit as it was. The
/// caller has checked that they lie in `bytes`. Any thread.
template <BitOrder order>
constexpr void writeBits(ByteSpan bytes, std::size_t firstBit, unsigned width, std::uint32_t value) noexcept {
    const std::size_t firstByte = firstBit / 8;
    const std::size_t lastByte = (firstBit + width - 1) / 8;
    const std::size_t shift =
        order == BitOrder::MsbFirst ? (lastByte + 1) * 8 - firstBit - width : firstBit % 8;
    const std::uint64_t mask = ((std::uint64_t{1} << width) - 1) << shift;
    const std::uint64_t window = std::uint64_t{value} << shift & mask;
    for (std::size_t i = firstByte; i <= lastByte; ++i) {
        const std::size_t down = 8 * (order == BitOrder::MsbFirst ? lastByte - i : i - firstByte);
        const auto keep = static_cast<std::uint8_t>(~(mask >> down));
        bytes[i] = static_cast<std::uint8_t>((bytes[i] & keep) | static_cast<std::uint8_t>(window >> down));
    }
}

/// A two's complement number of `width` bits (1-32), as it was read unsigned. Any thread.
constexpr std::int32_t signExtend(std::uint32_t value, unsigned width) noexcept {
    const std::uint32_t sign = std::uint32_t{1} << (width - 1);
    return static_cast<std::int32_t>((value ^ sign) - sign);
}

}  // namespace kickstand
