#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/bytes.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace kickstand {

/// The sum of all bytes, sixteen or eight at a time. Never allocates. Any thread.
inline std::uint64_t byteSum(ByteView bytes) noexcept {
    constexpr std::uint64_t kEven = 0x00FF00FF00FF00FF;
    constexpr std::uint64_t kOnes = 0x0001000100010001;
    // Of so many bytes the sums of each of the four lanes still fit into 16 bits, and so does their own sum.
    constexpr std::size_t kChunk = 256;
    std::uint64_t sum = 0;
#if defined(__SSE2__)
    __m128i sums = _mm_setzero_si128();
    for (; bytes.size() >= 16; bytes = bytes.subspan(16)) {
        const __m128i piece = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes.data()));
        sums = _mm_add_epi64(sums, _mm_sad_epu8(piece, _mm_setzero_si128()));
    }
    sum = static_cast<std::uint64_t>(_mm_cvtsi128_si64(sums)) +
          static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(sums, sums)));
#endif
    while (bytes.size() >= 8) {
        const std::size_t whole = std::min(bytes.size(), kChunk) & ~std::size_t{7};
        std::uint64_t lanes = 0;
        for (std::size_t at = 0; at < whole; at += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at, sizeof word);
            lanes += (word & kEven) + (word >> 8 & kEven);
        }
        sum += lanes * kOnes >> 48;
        bytes = bytes.subspan(whole);
    }
    for (const std::uint8_t byte : bytes)
        sum += byte;
    return sum;
}

}  // namespace kickstand
