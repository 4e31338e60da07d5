#pragma once

#include "qcustomplot.h"

#include "ui/plot/plot_painter.h"
#include "ui/plot/plot_state.h"

namespace kickstand::ui {

class SpanPlottable;

/// A plot's state as axes, grids and curves of a QCustomPlot: one axis area above the other.
class PlotScene final : public QObject {
    Q_OBJECT
  public:
    /// Both must outlive it.
    PlotScene(QCustomPlot& plot, PlotState& state);

    /// There are other areas now.
    void rebuild();
    /// There are other curves or words now.
    void invalidate();
    /// Draws the state as it is now.
    void draw();

    /// Where the areas lie, as they were drawn last.
    PlotGeometry geometry() const;
    /// How many columns the plot's width gives.
    int columns() const;
    /// Columns drawn so far in all areas, for whoever measures.
    std::uint64_t drawnColumns() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void recolour();
    void addArea(int index, bool last);
    void showRanges();
    void shareHeight();
    int laneRows() const;

    QCustomPlot& plot_;
    PlotState& state_;
    PlotFonts fonts_;
    DescribedMarks marks_;
    QSize shared_;  ///< Of the plot when its height was last shared out.
    QSharedPointer<QCPAxisTicker> timeTicker_;
    std::vector<QCPAxisRect*> rects_;
    std::vector<SpanPlottable*> spans_;
};

}  // namespace kickstand::ui
