#pragma once

#include <cstdint>
#include <limits>

#include "core/base/time.h"

namespace kickstand {

/// No value: what a gap holds.
inline constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/// A moment at which a quantity changed. kNoValue begins a gap.
struct Sample {
    TimePoint time{};
    float value = kNoValue;
};

/// Everything that held within one column of pixels, the value included that came in with it. All kNoValue
/// where nothing is known; `first` or `last` alone where a gap reaches into the column from that side.
struct Column {
    float min = kNoValue;
    float max = kNoValue;
    float first = kNoValue;   ///< What held at its beginning.
    float last = kNoValue;    ///< What held at its end.
    std::uint64_t count = 0;  ///< Changes within it, beginnings of gaps included.
};

/// A span of time in a few numbers.
struct SpanStats {
    float min = 0;
    float max = 0;
    double mean = 0;          ///< Weighted by how long each value held.
    Duration held{};          ///< The span less its gaps.
    std::uint64_t count = 0;  ///< Changes within it, beginnings of gaps included.
};

/// What a series has to read.
struct SampleRange {
    std::uint64_t firstIndex = 0;  ///< Counted from the first sample ever kept.
    std::uint64_t endIndex = 0;
    TimePoint first{};  ///< The oldest sample's time.
    TimePoint last{};   ///< The newest sample's time.
    /// How far back something is known, in blocks before `first`; else the same as that.
    TimePoint coarse{};
};

/// Why a series has no answer.
enum class Miss : std::uint8_t {
    NoValue,  ///< Nothing is known there: before the first sample, forgotten, or a gap.
    Overrun,  ///< The writer overwrote what was being read, again and again. Ask once more, later.
};

}  // namespace kickstand
