#pragma once

#include <QString>

#include "ui/plot/described_marks.h"
#include "ui/plot/mark_lane.h"
#include "ui/plot/plot_geometry.h"
#include "ui/plot/plot_text.h"

class QPainter;

namespace kickstand::ui {

struct Tokens;

/// Draws the marks of the time axis: their lines across the areas, and in the lane above them their shapes
/// and words. What the trigger caught is one of them.
class MarkPainter {
  public:
    /// `topEnd` is where the lane's top row ends.
    MarkPainter(const PlotState& state, const PlotGeometry& geometry, const Tokens& tokens,
                const PlotFonts& fonts, DescribedMarks& marks, double topEnd);

    void paintLines(QPainter& painter) const;
    void paintLane(QPainter& painter) const;

  private:
    struct Told {
        const DescribedMarks::Item* item;  ///< Null for the trigger.
        int look;
        QColor ink;
    };

    void collect(const DescribedMarks& marks);
    void addTrigger();
    QString textOf(const LaneWord& word) const;

    const PlotState& state_;
    const PlotGeometry& geometry_;
    const Tokens& t_;
    const PlotFonts& fonts_;
    DescribedMarks& marks_;
    std::vector<LaneMark> lane_;
    std::vector<Told> told_;
    LaneLayout layout_;
};

}  // namespace kickstand::ui
