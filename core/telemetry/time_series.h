#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "core/telemetry/area_sums.h"
#include "core/telemetry/past_blocks.h"
#include "core/telemetry/ring_index.h"
#include "core/telemetry/sample.h"
#include "core/telemetry/value_pyramid.h"

namespace kickstand {

/// One quantity over time, as the moments at which it changed: each value holds until the next one. Feedback
/// that has not changed is not sent again (protocol 6.9), so silence means "still the same"; that nothing is
/// known any more is said with a gap.
///
/// Bounded: the last capacity() samples are kept, in memory that is reserved once and taken as it fills (some
/// 13.4 bytes a cell; there are capacity() + 64 cells, rounded up to a power of two, so that 131,000 is
/// thrifty and 131,072 is not). What is older is known in blocks of a second (PastBlocks), where there is
/// room for them: columns, statistics and single values reach back into them. One thread writes. Any others
/// read at the same time, in place and without locks; no answer mixes samples with those that overwrote them.
class TimeSeries {
  public:
    template <class T>
    using Read = tl::expected<T, Miss>;

    /// Keeps the last `capacity` samples, and `pastBlocks` blocks of what was before.
    explicit TimeSeries(std::size_t capacity, std::size_t pastBlocks = 0);

    /// The value from `time` on. Kept only when it is not what holds already: true when it was kept. A value
    /// that is not finite begins a gap. A time before the last one is taken as the last one, and counted.
    /// Writer's thread.
    bool append(TimePoint time, float value);
    /// From `time` on nothing is known: the robot or the link is lost, or its readings are not valid.
    /// Writer's thread.
    bool gap(TimePoint time) { return append(time, kNoValue); }

    /// How many samples were ever kept: a reader that saw this number before has nothing new to draw. Any
    /// thread.
    std::uint64_t total() const { return index_.end(); }
    /// How many kept samples came with a time before that of the one before. Any thread.
    std::uint64_t outOfOrder() const { return outOfOrder_.load(std::memory_order_relaxed); }
    std::size_t capacity() const { return index_.capacity(); }
    /// Bytes reserved, which are all taken once the ring is full. Any thread.
    std::size_t bytes() const {
        return times_.bytes() + values_.bytes() + areas_.bytes() + (past_ ? past_->bytes() : 0);
    }

    /// What there is to read; NoValue while it is empty. Any thread.
    Read<SampleRange> available() const;
    /// The sample that holds at `time`, however long ago it came; the newest one for any later time. Any
    /// thread.
    Read<Sample> at(TimePoint time) const;
    /// The sample whose own time is nearest to `time`, beginnings of gaps left out. Any thread.
    Read<Sample> nearest(TimePoint time) const;
    /// Fills column i with what held in [start + i × width, start + (i + 1) × width); `width` is at least 1
    /// ns. The newest value holds on into the future: ask no further than the present. The cost grows with
    /// the number of columns and the logarithm of what lies in them. Never NoValue; after Overrun the columns
    /// mean nothing. Any thread.
    Read<void> columns(TimePoint start, Duration width, std::span<Column> out) const;
    /// What held in [from, to), at a cost that hardly depends on its length; NoValue when nothing did. Any
    /// thread.
    Read<SpanStats> stats(TimePoint from, TimePoint to) const;
    /// Copies samples as they were kept, from index `from` (counted like total()) on. Any thread.
    RingCopy copy(std::uint64_t from, std::span<Sample> out) const;

  private:
    TimePoint timeAt(std::uint64_t index) const { return TimePoint(Duration(times_.load(index))); }
    Sample sampleAt(std::uint64_t index) const { return {timeAt(index), values_.load(index)}; }
    std::uint64_t firstAtOrAfter(TimePoint time, std::uint64_t first, std::uint64_t end,
                                 std::uint64_t guess) const;
    std::uint64_t firstAfter(TimePoint time, RingWindow window) const;
    Sample nearestOf(std::uint64_t first, std::uint64_t end, TimePoint time) const;
    Column column(RingWindow window, std::uint64_t first, std::uint64_t end, TimePoint start) const;
    Area areaBetween(std::uint64_t first, std::uint64_t last) const;
    /// Up to when the blocks have to be asked: TimePoint::min() where every sample is still there.
    TimePoint forgottenUntil(RingWindow window) const;
    Area area(RingWindow window, std::uint64_t first, std::uint64_t end, TimePoint from, TimePoint to) const;

    RingIndex index_;
    RingCells<std::int64_t> times_;
    ValuePyramid values_;
    AreaSums areas_;
    std::optional<PastBlocks> past_;
    std::atomic<std::uint64_t> outOfOrder_{0};

    // The writer's own: what holds now, and the area up to its beginning.
    Sample holding_;
    Area areaSoFar_;
};

}  // namespace kickstand
