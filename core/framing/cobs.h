#pragma once

#include <cstddef>
#include <cstdint>

#include <tl/expected.hpp>

#include "core/base/bytes.h"

namespace kickstand {

/// Why bytes are no COBS encoding.
enum class CobsFault : std::uint8_t {
    Empty,      ///< Not even a code byte.
    Zero,       ///< A zero, which an encoding never holds.
    Truncated,  ///< A code byte announces more than there is.
};

/// Room for the encoding of `bytes` bytes, without any delimiter. Any thread.
constexpr std::size_t cobsMost(std::size_t bytes) noexcept {
    return bytes + bytes / 254 + 1;
}

/// Writes the Consistent Overhead Byte Stuffing of `bytes` to `out`, which has room for cobsMost() and is
/// apart from them; gives its length. Nothing in it is zero; the delimiter is the caller's. Any thread.
std::size_t cobsEncode(ByteView bytes, ByteSpan out) noexcept;

/// Writes what was encoded to `out`, which has as much room as `encoding` and is apart from it; gives its
/// length. After a fault `out` holds anything. Any thread.
tl::expected<std::size_t, CobsFault> cobsDecode(ByteView encoding, ByteSpan out) noexcept;

}  // namespace kickstand
