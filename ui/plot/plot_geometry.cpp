#include "ui/plot/plot_geometry.h"

#include <algorithm>

#include "ui/plot/mark_lane.h"

namespace kickstand::ui {

namespace {

/// Above, between and below words and shapes.
constexpr int kLaneAir = 2;
constexpr int kEndAir = 8;
constexpr int kBetweenAreas = 4;

}  // namespace

double PlotGeometry::xOf(const TimeView& view, TimePoint time) const {
    const QRect& rect = areas.front();
    return rect.left() + view.placeOf(time) * rect.width();
}

TimePoint PlotGeometry::timeAt(const TimeView& view, double x) const {
    const QRect& rect = areas.front();
    return view.timeAt((x - rect.left()) / std::max(rect.width(), 1));
}

double PlotGeometry::yOf(std::size_t area, const ValueRange& range, double value) const {
    const QRect& rect = areas[area];
    return rect.top() + (range.high - value) / range.size() * rect.height();
}

int PlotGeometry::areaAt(double y) const {
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (y <= areas[i].bottom() + kBetweenAreas) return static_cast<int>(i);
    }
    return static_cast<int>(areas.size()) - 1;
}

double PlotGeometry::laneGlyphTop() const {
    return areas.front().top() - kLaneAir / 2.0 - kLaneGlyph;
}

double PlotGeometry::laneRowTop(int row) const {
    return laneGlyphTop() - kLaneAir / 2.0 - (row + 1) * kLaneRowHeight;
}

double PlotGeometry::laneEnd() const {
    return areas.front().right() + labelRoom - kEndAir;
}

int laneHeight(int rows) {
    return 2 * kLaneAir + kLaneGlyph + rows * kLaneRowHeight;
}

}  // namespace kickstand::ui
