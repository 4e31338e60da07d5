#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/telemetry/ring_cells.h"

namespace kickstand {

/// The least and the greatest of some values. Of no values: none(), whose min is above its max.
struct alignas(8) Extremes {
    float min;
    float max;

    static constexpr Extremes none() {
        return {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    }
    bool empty() const { return min > max; }
    /// NaN is left out: both comparisons are false for it. Written as a choice, which is one instruction, and
    /// not as a branch, which noise makes unpredictable.
    void add(float value) { add(Extremes{value, value}); }
    void add(Extremes other) {
        min = other.min < min ? other.min : min;
        max = other.max > max ? other.max : max;
    }
};

/// The values of a series with the extremes of every 8, 64, 512… of them beside, so that the extremes of any
/// stretch cost its logarithm. One thread writes, others read; RingIndex says which indices are there to
/// read.
class ValuePyramid {
  public:
    /// `cells` values, a power of two.
    explicit ValuePyramid(std::size_t cells);

    /// Writer's thread; indices in order, from 0 on, each before it is published.
    void append(std::uint64_t index, float value);
    /// Any thread, as the next.
    float load(std::uint64_t index) const { return values_.load(index); }
    /// The extremes of the values [first, end), all of them published.
    Extremes extremes(std::uint64_t first, std::uint64_t end) const;
    std::size_t bytes() const;

  private:
    static constexpr std::uint64_t kFan = 8;
    static constexpr std::size_t kMaxLevels = 21;

    RingCells<float> values_;
    /// Level l holds one node for 8^(l + 1) values, written when the last of them is.
    std::vector<RingCells<Extremes>> levels_;
    /// The node that is being gathered on each level. The writer's own.
    std::array<Extremes, kMaxLevels> growing_{};
};

}  // namespace kickstand
