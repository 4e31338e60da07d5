#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace kickstand::bench {

/// How quickly an image can get into a robot's flash at all, worked out from the protocol alone and by other
/// means than the uploader's: erase + pages sent (fills needed + 1 ms + program time rounded up to a
/// millisecond + 1 ms for the response) + blocks (2 ms + CRC time), on a link of one packet a millisecond.
struct FlashBound {
    double erase_ms = 8000;
    double pages_ms = 0;
    double blocks_ms = 0;
    std::uint64_t packets = 0;

    double one_ms() const { return erase_ms + pages_ms + blocks_ms; }
    /// For several robots at once: the slowest of them, or the link where that is slower.
    double several_ms(int robots) const { return std::max(one_ms(), static_cast<double>(packets) * robots); }
    /// The same, counting that no page can go before the erasure that all begin with has ended.
    double severalErased_ms(int robots) const {
        return erase_ms + std::max(pages_ms + blocks_ms, static_cast<double>(packets) * robots);
    }
};

/// The fewest messages of 61 bytes that turn one page into another: for each byte from the last to the first,
/// how many it takes from there on.
inline int fillsBetween(const std::array<int, 256>& from, const std::array<int, 256>& to) {
    std::array<int, 256 + 61> needed{};
    for (int at = 255; at >= 0; --at) {
        const auto i = static_cast<std::size_t>(at);
        needed[i] = from[i] == to[i] ? needed[i + 1] : 1 + needed[i + 61];
    }
    return needed[0];
}

inline FlashBound flashBound(const std::vector<std::uint8_t>& image) {
    constexpr double kProgram_ms = 2;
    FlashBound bound;
    std::array<int, 256> buffer{};
    buffer.fill(-1);
    std::size_t end = 0;
    for (std::size_t page = 0; page * 256 < image.size(); ++page) {
        std::array<int, 256> wanted{};
        bool blank = true;
        for (std::size_t i = 0; i < 256; ++i) {
            const std::size_t address = page * 256 + i;
            wanted[i] = address < image.size() ? image[address] : 0xFF;
            blank = blank && wanted[i] == 0xFF;
        }
        if (blank) continue;
        const int fills = fillsBetween(buffer, wanted);
        buffer = wanted;
        end = (page + 1) * 256;
        bound.packets += static_cast<std::uint64_t>(fills) + 1;
        bound.pages_ms += fills + 1 + kProgram_ms + 1;
    }
    for (std::size_t at = 0; at < end; at += 65536) {
        ++bound.packets;
        bound.blocks_ms += 2 + static_cast<double>(std::min<std::size_t>(65536, end - at)) / 1000;
    }
    return bound;
}

}  // namespace kickstand::bench
