#pragma once

#include <QRect>
#include <vector>

#include "ui/plot/time_view.h"
#include "ui/plot/value_range.h"

namespace kickstand::ui {

/// Where things lie on the screen: one rectangle an area, top to bottom, and above them the lane in which
/// marks are told.
struct PlotGeometry {
    std::vector<QRect> areas;
    int labelRoom = 0;  ///< Pixels to the right of an area.
    int laneRows = 1;

    bool empty() const { return areas.empty(); }
    /// Horizontal pixels are the same in all areas.
    double xOf(const TimeView& view, TimePoint time) const;
    TimePoint timeAt(const TimeView& view, double x) const;
    double yOf(std::size_t area, const ValueRange& range, double value) const;
    /// The area at a height, its surroundings included; -1 where there is none.
    int areaAt(double y) const;

    /// Where the shapes of marks stand, right above the first area.
    double laneGlyphTop() const;
    /// Of a row of words, counted from the areas upwards.
    double laneRowTop(int row) const;
    /// Where words end at the right.
    double laneEnd() const;
};

/// The height of a row of words, and of a lane of so many.
inline constexpr int kLaneRowHeight = 13;
int laneHeight(int rows);

}  // namespace kickstand::ui
