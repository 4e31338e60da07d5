#include "core/telemetry/past_blocks.h"

#include <algorithm>
#include <cmath>

namespace kickstand {

PastBlocks::PastBlocks(std::size_t blocks, std::size_t samples)
    : index_(blocks),
      samples_(std::max<std::size_t>(samples, 1)),
      begins_(index_.cells()),
      lasts_(index_.cells()),
      untils_(index_.cells()),
      held_(index_.cells()),
      firstValues_(index_.cells()),
      lastValues_(index_.cells()),
      firstIndices_(index_.cells()),
      areaValues_(index_.cells()),
      areaHeld_(index_.cells()) {}

std::size_t PastBlocks::bytes() const {
    return begins_.bytes() + lasts_.bytes() + untils_.bytes() + held_.bytes() + firstValues_.bytes() +
           lastValues_.bytes() + firstIndices_.bytes() + areaValues_.bytes() + areaHeld_.bytes();
}

void PastBlocks::append(std::uint64_t index, const Sample& sample, const Area& upToHere) {
    Growing& growing = growing_;
    const bool toOrFromGap = std::isnan(sample.value) || std::isnan(growing.lastValue);
    const bool full = growing.samples == samples_ || sample.time - growing.begin >= kSpan;
    if (growing.samples > 0 && (toOrFromGap || full)) {
        close(sample.time, upToHere);
        growing = {};
    }
    if (growing.samples++ == 0) {
        growing.begin = sample.time;
        growing.firstValue = sample.value;
        growing.firstIndex = index;
    }
    growing.last = sample.time;
    growing.lastValue = sample.value;
    growing.held.add(sample.value);
}

void PastBlocks::close(TimePoint until, const Area& upToHere) {
    const std::uint64_t block = index_.end();
    begins_.store(block, growing_.begin.time_since_epoch().count());
    lasts_.store(block, growing_.last.time_since_epoch().count());
    untils_.store(block, until.time_since_epoch().count());
    held_.store(block, growing_.held);
    firstValues_.store(block, growing_.firstValue);
    lastValues_.store(block, growing_.lastValue);
    firstIndices_.store(block, growing_.firstIndex);
    areaValues_.store(block, upToHere.value_s);
    areaHeld_.store(block, upToHere.held.count());
    index_.publish();
}

std::optional<TimePoint> PastBlocks::begin() const {
    const auto result = index_.consistently([this](RingWindow window) {
        return window.first == window.end ? TimePoint::max() : beginOf(window.first);
    });
    if (!result || *result == TimePoint::max()) return std::nullopt;
    return result;
}

std::uint64_t PastBlocks::blockAt(TimePoint time, RingWindow window, std::uint64_t guess) const {
    const std::uint64_t next = partitionRing(window.first, window.end, guess,
                                             [&](std::uint64_t block) { return beginOf(block) <= time; });
    return next == window.first ? window.end : next - 1;
}

Column PastBlocks::column(RingWindow window, std::uint64_t& guess, TimePoint from, TimePoint to) const {
    Column result;
    std::uint64_t block = blockAt(from, window, guess);
    Extremes held = Extremes::none();
    if (block == window.end) {
        block = window.first;
    } else {
        const bool still = timeOf(lasts_.load(block)) <= from;
        // Beyond the newest block the series itself knows.
        if (still && timeOf(untils_.load(block)) <= from) return result;
        result.first = still ? lastValues_.load(block) : firstValues_.load(block);
        result.last = lastValues_.load(block);
        held.add(result.last);
        if (!still) held.add(held_.load(block));
        ++block;
    }
    const std::uint64_t firstIndex = block < window.end ? firstIndices_.load(block) : 0;
    for (; block < window.end && beginOf(block) < to; ++block) {
        held.add(held_.load(block));
        result.last = lastValues_.load(block);
        if (block + 1 < window.end) result.count = firstIndices_.load(block + 1) - firstIndex;
    }
    guess = block;
    if (!held.empty()) {
        result.min = held.min;
        result.max = held.max;
    }
    return result;
}

bool PastBlocks::columns(TimePoint start, Duration width, TimePoint until, std::span<Column> out) const {
    return index_
        .consistently([&](RingWindow window) {
            TimePoint left = start;
            std::uint64_t guess = window.first;
            for (Column& filled : out) {
                if (left >= until || window.first == window.end) break;
                filled = column(window, guess, left, std::min(left + width, until));
                left += width;
            }
            return true;
        })
        .has_value();
}

Area PastBlocks::areaUpTo(TimePoint time, RingWindow window) const {
    const auto after = [this](std::uint64_t block) {
        return Area{areaValues_.load(block), Duration(areaHeld_.load(block))};
    };
    const std::uint64_t block = blockAt(time, window, window.end);
    // What came before the oldest block has been forgotten, and so has that one's own share.
    if (block == window.end || block == window.first) return after(window.first);
    const Area before = after(block - 1);
    const Area share = after(block) - before;
    const TimePoint begin = beginOf(block);
    const TimePoint until = timeOf(untils_.load(block));
    if (time >= until) return before + share;
    const double part = seconds(time - begin) / seconds(until - begin);
    return before + Area{share.value_s * part,
                         Duration(static_cast<std::int64_t>(static_cast<double>(share.held.count()) * part))};
}

std::optional<Area> PastBlocks::area(TimePoint from, TimePoint to) const {
    return index_.consistently([&](RingWindow window) {
        if (window.first == window.end || to <= from) return Area{};
        return areaUpTo(to, window) - areaUpTo(from, window);
    });
}

std::optional<Sample> PastBlocks::at(TimePoint time) const {
    return index_.consistently([&](RingWindow window) {
        const std::uint64_t block = blockAt(time, window, window.end);
        if (block == window.end || time >= timeOf(untils_.load(block))) return Sample{};
        const TimePoint last = timeOf(lasts_.load(block));
        if (time >= last) return Sample{last, lastValues_.load(block)};
        return Sample{beginOf(block), firstValues_.load(block)};
    });
}

}  // namespace kickstand
