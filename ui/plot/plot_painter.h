#pragma once

#include <QColor>
#include <QFont>
#include <QRect>
#include <vector>

#include "ui/plot/plot_state.h"

class QPainter;

namespace kickstand::ui {

struct Tokens;

/// Where things lie on the screen: one rectangle an area, top to bottom.
struct PlotGeometry {
    std::vector<QRect> areas;
    int labelRoom = 0;  ///< Pixels to the right of an area.

    bool empty() const { return areas.empty(); }
    /// Horizontal pixels are the same in all areas.
    double xOf(const TimeView& view, TimePoint time) const;
    TimePoint timeAt(const TimeView& view, double x) const;
    double yOf(std::size_t area, const ValueRange& range, double value) const;
    /// The area at a height, its surroundings included; -1 where there is none.
    int areaAt(double y) const;
};

/// The plot's small letters. Finding digits of one width takes time: made once a theme.
struct PlotFonts {
    QFont text;
    QFont strong;
    QFont number;
};
PlotFonts plotFonts();

/// Draws what lies under and over the curves: thresholds; marks, cursors, trigger, labels.
class PlotPainter {
  public:
    PlotPainter(const PlotState& state, const PlotGeometry& geometry, const Tokens& tokens,
                const PlotFonts& fonts)
        : state_(state), geometry_(geometry), t_(tokens), fonts_(fonts) {}

    void paintUnder(QPainter& painter) const;
    void paintOver(QPainter& painter) const;

  private:
    struct ShownMark {
        double x;
        MarkWords words;
    };

    void paintThresholds(QPainter& painter, std::size_t area) const;
    void paintTitle(QPainter& painter, std::size_t area) const;
    void paintEnds(QPainter& painter, std::size_t area) const;
    void paintMarks(QPainter& painter) const;
    void paintMarkLabels(QPainter& painter, const std::vector<ShownMark>& marks) const;
    void paintTrigger(QPainter& painter) const;
    void paintCursors(QPainter& painter) const;
    void line(QPainter& painter, double x, const QColor& colour, Qt::PenStyle style) const;

    const PlotState& state_;
    const PlotGeometry& geometry_;
    const Tokens& t_;
    const PlotFonts& fonts_;
};

/// The mark whose line is nearest to x, at most some pixels away.
std::optional<Mark> markNear(const PlotState& state, const PlotGeometry& geometry, double x);

/// Labels of equal height at wanted places (their middles, rising), moved apart as little as will do within
/// [top, bottom]. Fewer than were asked for where they do not all fit: the last ones are left out.
std::vector<double> spreadLabels(std::vector<double> wanted, double height, double top, double bottom);

}  // namespace kickstand::ui
