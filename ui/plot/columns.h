#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/time.h"

namespace kickstand::ui {

/// Columns of pixels, each of which stands for a stretch of time. They are counted from the clock's zero and
/// not from an edge of the picture: a column keeps its number, and what is drawn in it, while the view moves.
struct ColumnSpan {
    std::int64_t first = 0;
    std::int64_t end = 0;  ///< The first one that is no part of it.

    std::int64_t count() const { return std::max<std::int64_t>(end - first, 0); }
    bool empty() const { return end <= first; }
    friend bool operator==(const ColumnSpan&, const ColumnSpan&) = default;
};

constexpr ColumnSpan commonOf(ColumnSpan a, ColumnSpan b) {
    return {std::max(a.first, b.first), std::min(a.end, b.end)};
}

/// Whole numbers divided downwards, also below zero; `divisor` is at least 1.
constexpr std::int64_t floorDivide(std::int64_t number, std::int64_t divisor) {
    return number / divisor - (number % divisor < 0 ? 1 : 0);
}

/// The column of a moment, where each is `width` wide; that is at least 1 ns.
constexpr std::int64_t columnAt(TimePoint time, Duration width) {
    return floorDivide(time.time_since_epoch().count(), width.count());
}

/// Where a column begins.
constexpr TimePoint startOf(std::int64_t column, Duration width) {
    return TimePoint(width * column);
}

}  // namespace kickstand::ui
