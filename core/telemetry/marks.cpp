#include "core/telemetry/marks.h"

#include <algorithm>
#include <bit>

namespace kickstand {

Marks::Marks(std::size_t capacity) : index_(capacity), times_(index_.cells()), what_(index_.cells()) {}

void Marks::append(Mark mark) {
    last_ = std::max(last_, mark.time);
    const std::uint64_t index = index_.end();
    times_.store(index, last_.time_since_epoch().count());
    what_.store(index, static_cast<std::uint64_t>(mark.kind) << 48 |
                           static_cast<std::uint64_t>(mark.unit) << 32 |
                           std::bit_cast<std::uint32_t>(mark.value));
    index_.publish();
}

Mark Marks::markAt(std::uint64_t index) const {
    const std::uint64_t what = what_.load(index);
    return {TimePoint(Duration(times_.load(index))), static_cast<MarkKind>(what >> 48),
            static_cast<std::uint16_t>(what >> 32 & 0xFFFF),
            std::bit_cast<float>(static_cast<std::uint32_t>(what & 0xFFFFFFFF))};
}

std::uint64_t Marks::firstAtOrAfter(TimePoint time, RingWindow window) const {
    return partitionRing(window.first, window.end, window.end,
                         [&](std::uint64_t index) { return TimePoint(Duration(times_.load(index))) < time; });
}

std::optional<std::vector<Mark>> Marks::between(TimePoint from, TimePoint to) const {
    return index_.consistently([&](RingWindow window) {
        std::vector<Mark> found;
        const std::uint64_t end = firstAtOrAfter(to, window);
        for (std::uint64_t index = firstAtOrAfter(from, window); index < end; ++index)
            found.push_back(markAt(index));
        return found;
    });
}

RingCopy Marks::copy(std::uint64_t from, std::span<Mark> out) const {
    return index_.copy(from, out, [&](std::uint64_t index) { return markAt(index); });
}

}  // namespace kickstand
