#include "core/framing/cobs.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/framing/byte_places.h"

namespace kickstand {
namespace {

/// The code of a block that no zero follows.
constexpr std::uint8_t kFullCode = 0xFF;
constexpr std::size_t kFullBlock = kFullCode - 1;
/// So many codes are written or followed before it is asked whether that was all: more than most messages
/// have, since a branch that is foretold wrongly costs more than some codes for nothing.
constexpr int kAtOnce = 6;

/// A bit for each byte that is zero; at most a stripe of them.
std::uint64_t zerosOf(const std::uint8_t* bytes, std::size_t size) noexcept {
    return placesOf(bytes, size, 0);
}

bool hasZero(ByteView bytes) noexcept {
    std::uint64_t zeros = 0;
    for (std::size_t i = 0; i < bytes.size(); i += kStripe)
        zeros |= zerosOf(bytes.data() + i, std::min(kStripe, bytes.size() - i));
    return zeros != 0;
}

/// Bytes that have no room for a full block: they move up by one as they are, and only the codes, which take
/// the places of the zeros, are left to be written.
std::size_t encodeShort(ByteView bytes, std::uint8_t* out) noexcept {
    const std::size_t size = bytes.size();
    std::memcpy(out + 1, bytes.data(), size);
    std::size_t code = 0;
    for (std::size_t i = 0; i < size; i += kStripe) {
        const std::size_t here = std::min(kStripe, size - i);
        std::uint64_t zeros = zerosOf(bytes.data() + i, here);
        while (zeros != 0) {
            for (int n = 0; n < kAtOnce; ++n) {
                const std::size_t place = i + static_cast<std::size_t>(std::countr_zero(zeros));
                // Without another zero this is written for nothing, and once more below.
                out[code] = static_cast<std::uint8_t>(place + 1 - code);
                code = zeros != 0 ? place + 1 : code;
                zeros &= zeros - 1;
            }
        }
    }
    out[code] = static_cast<std::uint8_t>(size + 1 - code);
    return size + 1;
}

/// As encodeShort(), back: without full blocks all moves down by one, and codes turn into the zeros that they
/// stand for.
tl::expected<std::size_t, CobsFault> decodeShort(ByteView encoding, std::uint8_t* out) noexcept {
    const std::size_t size = encoding.size();
    std::memcpy(out, encoding.data() + 1, size - 1);
    std::size_t place = encoding[0];
    while (place < size) {
        out[place - 1] = 0;
        place += encoding[place];
    }
    if (place > size) return tl::unexpected(CobsFault::Truncated);
    return size - 1;
}

}  // namespace

std::size_t cobsEncode(ByteView bytes, ByteSpan out) noexcept {
    if (bytes.empty()) {
        out[0] = 1;
        return 1;
    }
    if (bytes.size() < kFullBlock) return encodeShort(bytes, out.data());
    std::size_t written = 0;
    for (;;) {
        const ByteView ahead = bytes.first(std::min(bytes.size(), kFullBlock));
        const auto run = static_cast<std::size_t>(std::find(ahead.begin(), ahead.end(), 0) - ahead.begin());
        out[written++] = static_cast<std::uint8_t>(run + 1);
        std::copy_n(bytes.begin(), run, out.begin() + static_cast<std::ptrdiff_t>(written));
        written += run;
        if (run == bytes.size()) return written;
        bytes = bytes.subspan(run == kFullBlock ? run : run + 1);
        // A zero at the very end is followed by an empty block, a full block there by nothing.
        if (bytes.empty() && run < kFullBlock) out[written++] = 1;
        if (bytes.empty()) return written;
    }
}

tl::expected<std::size_t, CobsFault> cobsDecode(ByteView encoding, ByteSpan out) noexcept {
    const std::size_t size = encoding.size();
    if (size == 0) return tl::unexpected(CobsFault::Empty);
    if (hasZero(encoding)) return tl::unexpected(CobsFault::Zero);
    if (size <= kFullBlock) return decodeShort(encoding, out.data());
    std::size_t place = 0;
    std::size_t written = 0;
    while (place < size) {
        const std::size_t run = encoding[place] - 1U;
        if (run > size - place - 1) return tl::unexpected(CobsFault::Truncated);
        std::copy_n(encoding.begin() + static_cast<std::ptrdiff_t>(place) + 1, run,
                    out.begin() + static_cast<std::ptrdiff_t>(written));
        written += run;
        place += run + 1;
        if (run < kFullBlock && place < size) out[written++] = 0;
    }
    return written;
}

}  // namespace kickstand
