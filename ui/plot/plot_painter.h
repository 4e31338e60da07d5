#pragma once

#include <QColor>
#include <QRectF>
#include <vector>

#include "ui/plot/described_marks.h"
#include "ui/plot/plot_geometry.h"
#include "ui/plot/plot_state.h"
#include "ui/plot/plot_text.h"

class QPainter;

namespace kickstand::ui {

struct Tokens;

/// Draws what lies under and over the curves: thresholds; marks, cursors, trigger, labels.
class PlotPainter {
  public:
    PlotPainter(const PlotState& state, const PlotGeometry& geometry, const Tokens& tokens,
                const PlotFonts& fonts, DescribedMarks& marks)
        : state_(state), geometry_(geometry), t_(tokens), fonts_(fonts), marks_(marks) {}

    void paintUnder(QPainter& painter) const;
    void paintOver(QPainter& painter) const;

  private:
    void paintNames(QPainter& painter, std::size_t area) const;
    QRectF paintTitle(QPainter& painter, std::size_t area) const;
    QRectF paintTriggerName(QPainter& painter, std::size_t area) const;
    void paintEnds(QPainter& painter, std::size_t area) const;
    void paintCursorLines(QPainter& painter) const;
    void paintCursorFlags(QPainter& painter) const;
    /// Where the time between the cursors stands, in the lane's top row.
    QRectF deltaPlace() const;
    std::optional<double> triggerLevel(std::size_t area) const;

    const PlotState& state_;
    const PlotGeometry& geometry_;
    const Tokens& t_;
    const PlotFonts& fonts_;
    DescribedMarks& marks_;
};

/// The mark whose line is nearest to x, at most some pixels away.
std::optional<Mark> markNear(const PlotState& state, const PlotGeometry& geometry, double x);

/// Labels of equal height at wanted places (their middles, rising), moved apart as little as will do within
/// [top, bottom]. Fewer than were asked for where they do not all fit: the last ones are left out.
std::vector<double> spreadLabels(std::vector<double> wanted, double height, double top, double bottom);

}  // namespace kickstand::ui
