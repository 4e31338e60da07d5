#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/bytes.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace kickstand {

/// How many bytes are looked at together: as many as a word has bits.
inline constexpr std::size_t kStripe = 64;

#if defined(__SSE2__)

/// A bit for each of sixteen bytes that is `value`.
inline std::uint64_t placesOf16(const std::uint8_t* bytes, std::uint8_t value) noexcept {
    const __m128i loaded = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes));
    const __m128i wanted = _mm_set1_epi8(static_cast<char>(value));
    return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(loaded, wanted)));
}

#else

inline std::uint64_t placesOf16(const std::uint8_t* bytes, std::uint8_t value) noexcept {
    std::uint64_t places = 0;
    for (unsigned i = 0; i < 16; ++i)
        places |= std::uint64_t{bytes[i] == value} << i;
    return places;
}

#endif

/// A bit for each byte of a whole stripe that is `value`, the first one lowest. Never allocates. Any thread.
inline std::uint64_t placesOf(const std::uint8_t* stripe, std::uint8_t value) noexcept {
    return placesOf16(stripe, value) | placesOf16(stripe + 16, value) << 16 |
           placesOf16(stripe + 32, value) << 32 | placesOf16(stripe + 48, value) << 48;
}

/// The same for at most a stripe.
inline std::uint64_t placesOf(const std::uint8_t* bytes, std::size_t size, std::uint8_t value) noexcept {
    if (size == kStripe) return placesOf(bytes, value);
    std::uint64_t places = 0;
    unsigned i = 0;
    for (; i + 16 <= size; i += 16)
        places |= placesOf16(bytes + i, value) << i;
    for (; i < size; ++i)
        places |= std::uint64_t{bytes[i] == value} << i;
    return places;
}

}  // namespace kickstand
