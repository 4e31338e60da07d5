#pragma once

#include "qcustomplot.h"

#include "ui/plot/column_ring.h"
#include "ui/plot/plot_state.h"
#include "ui/plot/span_image.h"

namespace kickstand::ui {

/// The curves of one area: reads their series in place, column for column, into a ring of pixels of which
/// only new columns are drawn. Following and panning are then a copy.
class SpanPlottable final : public QCPAbstractPlottable {
    Q_OBJECT
  public:
    /// `state` must outlive it; `area` is the index of the area that it draws.
    SpanPlottable(QCPAxis* time, QCPAxis* value, const PlotState& state, int area);

    /// Curves or their colours are others now.
    void invalidate() { valid_ = false; }
    /// Columns drawn so far, for whoever measures.
    std::uint64_t drawnColumns() const { return drawnColumns_; }

    double selectTest(const QPointF& pos, bool onlySelectable, QVariant* details) const override;
    QCPRange getKeyRange(bool& found, QCP::SignDomain domain) const override;
    QCPRange getValueRange(bool& found, QCP::SignDomain domain, const QCPRange& keys) const override;

  protected:
    void draw(QCPPainter* painter) override;
    void drawLegendIcon(QCPPainter* painter, const QRectF& rect) const override;

  private:
    /// What the picture's columns were drawn for: with any other they mean nothing.
    struct Basis {
        Duration columnWidth{};
        ValueRange range;
        int places = 0;
        int rows = 0;
        double pixelRatio = 0;
        bool dark = false;
        friend bool operator==(const Basis&, const Basis&) = default;
    };

    void rebuild(const Basis& basis);
    void drawColumns(ColumnSpan span);
    void drawBlock(std::int64_t first, int count);

    const PlotState& state_;
    int area_;
    bool valid_ = false;
    Basis basis_;
    ColumnRing ring_;
    SpanImage image_;
    std::vector<PlotCurve> curves_;
    std::vector<Column> columns_;
    std::vector<DrawnSpan> spans_;
    std::uint64_t drawnColumns_ = 0;
};

/// How many device pixels thick lines are.
int strokeOf(double pixelRatio);

}  // namespace kickstand::ui
