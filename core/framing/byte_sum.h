#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace kickstand {

/// The sum of all bytes. Never allocates. Any thread.
inline std::uint64_t byteSum(ByteView bytes) noexcept {
    std::uint64_t sum = 0;
    std::size_t at = 0;
#if defined(__SSE2__)
    __m128i sums = _mm_setzero_si128();
    for (; at + 16 <= bytes.size(); at += 16) {
        const __m128i piece = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes.data() + at));
        sums = _mm_add_epi64(sums, _mm_sad_epu8(piece, _mm_setzero_si128()));
    }
    sum = static_cast<std::uint64_t>(_mm_cvtsi128_si64(sums)) +
          static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(sums, sums)));
#endif
    for (; at < bytes.size(); ++at)
        sum += bytes[at];
    return sum;
}

}  // namespace kickstand
