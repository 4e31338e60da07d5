#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/telemetry/area_sums.h"
#include "core/telemetry/ring_index.h"
#include "core/telemetry/sample.h"
#include "core/telemetry/value_pyramid.h"

namespace kickstand {

/// What a series has forgotten, told in blocks of a second or less: hours in the memory of minutes. A block
/// says between which values the series moved, and what it began and ended with. A gap is a block of its own,
/// and so is what follows it, so that no block tells of a time of which nothing was known. One thread writes,
/// others read.
class PastBlocks {
  public:
    /// How much time one block covers at most, from its first sample to its last.
    static constexpr Duration kSpan = std::chrono::seconds(1);

    /// Keeps the last `blocks`, each of at most `samples` samples; both at least 1.
    PastBlocks(std::size_t blocks, std::size_t samples);

    /// Sample number `index` of the series; `upToHere` is the area before it. Writer's thread.
    void append(std::uint64_t index, const Sample& sample, const Area& upToHere);

    /// Whether there is any block. Any thread, as the next.
    bool empty() const { return index_.end() == 0; }
    /// Where the oldest block begins; nothing while there is none.
    std::optional<TimePoint> begin() const;
    /// Fills column i with what the blocks say of [start + i × width, start + (i + 1) × width) before
    /// `until`; the others are left. False when the writer overtook the reader.
    bool columns(TimePoint start, Duration width, TimePoint until, std::span<Column> out) const;
    /// The area in [from, to), to the resolution of a block; nothing when the writer overtook the reader.
    std::optional<Area> area(TimePoint from, TimePoint to) const;
    /// What about held at `time`; NoValue where nothing is known.
    std::optional<Sample> at(TimePoint time) const;
    std::size_t bytes() const;

  private:
    /// A block that is being gathered.
    struct Growing {
        TimePoint begin{};
        TimePoint last{};
        Extremes held = Extremes::none();
        float firstValue = kNoValue;
        float lastValue = kNoValue;
        std::uint64_t firstIndex = 0;
        std::size_t samples = 0;
    };

    static TimePoint timeOf(std::int64_t count) { return TimePoint(Duration(count)); }
    TimePoint beginOf(std::uint64_t block) const { return timeOf(begins_.load(block)); }
    /// The block that holds at `time`; `window.end` where none begins by then.
    std::uint64_t blockAt(TimePoint time, RingWindow window, std::uint64_t guess) const;
    void close(TimePoint until, const Area& upToHere);
    Column column(RingWindow window, std::uint64_t& guess, TimePoint from, TimePoint to) const;
    Area areaUpTo(TimePoint time, RingWindow window) const;

    RingIndex index_;
    std::size_t samples_;
    RingCells<std::int64_t> begins_;
    RingCells<std::int64_t> lasts_;   ///< When the last change came.
    RingCells<std::int64_t> untils_;  ///< When the next block begins.
    RingCells<Extremes> held_;
    RingCells<float> firstValues_;
    RingCells<float> lastValues_;
    RingCells<std::uint64_t> firstIndices_;
    RingCells<double> areaValues_;  ///< Up to the end of the block.
    RingCells<std::int64_t> areaHeld_;
    Growing growing_;  ///< The writer's own.
};

}  // namespace kickstand
