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

namespace detail {

/// The bytes `first` to `last`, five at most, as one number in their order. Spelt out rather than a loop:
/// where the place is a constant, as in every codec, only the loads that it needs are left.
template <BitOrder order>
constexpr std::uint64_t loadWindow(ByteView bytes, std::size_t first, std::size_t last) noexcept {
    const std::size_t more = last - first;
    const auto byte = [&](std::size_t i) {
        if (i > more) return std::uint64_t{0};
        const std::size_t shift = 8 * (order == BitOrder::MsbFirst ? more - i : i);
        return std::uint64_t{bytes[first + i]} << shift;
    };
    return byte(0) | byte(1) | byte(2) | byte(3) | byte(4);
}

/// How far up in its window the lowest bit of a field lies.
template <BitOrder order>
constexpr std::size_t shiftInWindow(std::size_t firstBit, unsigned width, std::size_t lastByte) noexcept {
    return order == BitOrder::MsbFirst ? (lastByte + 1) * 8 - firstBit - width : firstBit % 8;
}

}  // namespace detail

/// The unsigned number in `width` bits (1-32) from `firstBit`. The caller has checked that they lie in
/// `bytes`. Any thread.
template <BitOrder order>
constexpr std::uint32_t readBits(ByteView bytes, std::size_t firstBit, unsigned width) noexcept {
    const std::size_t lastByte = (firstBit + width - 1) / 8;
    const std::uint64_t window = detail::loadWindow<order>(bytes, firstBit / 8, lastByte);
    const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
    return static_cast<std::uint32_t>(window >> detail::shiftInWindow<order>(firstBit, width, lastByte) &
                                      mask);
}

/// Writes the low `width` bits (1-32) of `value` from `firstBit` and leaves every other bit as it was. The
/// caller has checked that they lie in `bytes`. Any thread.
template <BitOrder order>
constexpr void writeBits(ByteSpan bytes, std::size_t firstBit, unsigned width, std::uint32_t value) noexcept {
    const std::size_t firstByte = firstBit / 8;
    const std::size_t lastByte = (firstBit + width - 1) / 8;
    const std::size_t shift = detail::shiftInWindow<order>(firstBit, width, lastByte);
    const std::uint64_t mask = ((std::uint64_t{1} << width) - 1) << shift;
    const std::uint64_t window = std::uint64_t{value} << shift & mask;
    const auto store = [&](std::size_t i) {
        if (i > lastByte) return;
        const std::size_t down = 8 * (order == BitOrder::MsbFirst ? lastByte - i : i - firstByte);
        const auto keep = static_cast<std::uint8_t>(~(mask >> down));
        bytes[i] = static_cast<std::uint8_t>((bytes[i] & keep) | static_cast<std::uint8_t>(window >> down));
    };
    store(firstByte);
    store(firstByte + 1);
    store(firstByte + 2);
    store(firstByte + 3);
    store(firstByte + 4);
}

/// A two's complement number of `width` bits (1-32), as it was read unsigned. Any thread.
constexpr std::int32_t signExtend(std::uint32_t value, unsigned width) noexcept {
    const std::uint32_t sign = std::uint32_t{1} << (width - 1);
    return static_cast<std::int32_t>((value ^ sign) - sign);
}

}  // namespace kickstand
