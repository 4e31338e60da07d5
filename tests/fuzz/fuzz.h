#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/base/bytes.h"

/// Called with one input after another; what it must not do is crash, hang, or break its own require().
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace kickstand::fuzz {

/// A property that holds for every input.
inline void require(bool holds, const char* what) {
    if (holds) return;
    static_cast<void>(std::fprintf(stderr, "broken: %s\n", what));
    std::abort();
}

inline bool sameBytes(ByteView a, ByteView b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// What is accepted must come back: decoded, encoded and decoded again it is the same value and the same
/// bytes.
template <class Decode, class Encode>
void requireEcho(ByteView input, Decode decode, Encode encode) {
    const auto decoded = decode(input);
    if (!decoded) return;
    const auto encoded = encode(*decoded);
    require(encoded.has_value(), "what was read can be written");
    const ByteView bytes{encoded->data(), encoded->size()};
    require(sameBytes(bytes, input), "what was written are the bytes that were read");
    require(*decode(bytes) == *decoded, "what was written reads as the same");
}

}  // namespace kickstand::fuzz
