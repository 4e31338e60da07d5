#include "ui/plot/span_plottable.h"

#include <algorithm>
#include <cmath>

#include "ui/plot/curve_colours.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

/// Columns are read in blocks of so many, so that those of all curves stay in the cache.
constexpr int kBlock = 128;
/// What is older is complete: the engine has written all that it knows of that time.
constexpr auto kSettled = 100ms;

}  // namespace

int strokeOf(double pixelRatio) {
    return std::max(1, static_cast<int>(std::lround(pixelRatio)));
}

SpanPlottable::SpanPlottable(QCPAxis* time, QCPAxis* value, const PlotState& state, int area)
    : QCPAbstractPlottable(time, value), state_(state), area_(area) {
    setSelectable(QCP::stNone);
}

double SpanPlottable::selectTest(const QPointF&, bool, QVariant*) const {
    return -1;
}

QCPRange SpanPlottable::getKeyRange(bool& found, QCP::SignDomain) const {
    found = false;
    return {};
}

QCPRange SpanPlottable::getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const {
    found = false;
    return {};
}

void SpanPlottable::drawLegendIcon(QCPPainter*, const QRectF&) const {}

void SpanPlottable::draw(QCPPainter* painter) {
    const QRect rect = keyAxis()->axisRect()->rect();
    const double ratio = painter->device()->devicePixelRatioF();
    const QCPRange values = valueAxis()->range();
    const Basis basis{state_.view.columnWidth(),
                      {values.lower, values.upper},
                      state_.view.columns(),
                      static_cast<int>(rect.height() * ratio),
                      ratio,
                      tokensOf(parentPlot()->palette()).dark};
    if (basis.rows < 2) return;
    if (!valid_ || basis != basis_) rebuild(basis);

    const ColumnSpan shown = state_.view.shown();
    const TimePoint now = state_.view.now();
    const std::int64_t present = columnAt(now, basis.columnWidth) + 1;
    for (const ColumnSpan& span : ring_.show(shown, columnAt(now - kSettled, basis.columnWidth), present))
        drawColumns(span);
    const double placeWidth = strokeOf(ratio) / ratio;
    for (const ColumnRing::Piece& piece : ring_.piecesOf(commonOf(shown, {shown.first, present}))) {
        const double x = rect.left() + static_cast<double>(piece.first - shown.first) * placeWidth;
        image_.show(*painter, x, rect.top(), piece.place, piece.count);
    }
}

void SpanPlottable::rebuild(const Basis& basis) {
    if (basis.places != basis_.places || basis.rows != basis_.rows || basis.pixelRatio != basis_.pixelRatio)
        image_.resize(basis.places, basis.rows, strokeOf(basis.pixelRatio), basis.pixelRatio);
    basis_ = basis;
    valid_ = true;
    ring_.reset(basis.places);
    curves_.clear();
    std::copy_if(state_.curves.begin(), state_.curves.end(), std::back_inserter(curves_),
                 [this](const PlotCurve& curve) { return curve.area == area_; });
    columns_.assign(std::max<std::size_t>(curves_.size(), 1) * kBlock, Column{});
    spans_.assign(std::max<std::size_t>(curves_.size(), 1), DrawnSpan{});
}

void SpanPlottable::drawColumns(ColumnSpan span) {
    for (const ColumnRing::Piece& piece : ring_.piecesOf(span)) {
        for (int done = 0; done < piece.count; done += kBlock)
            drawBlock(piece.first + done, std::min(kBlock, piece.count - done));
    }
}

void SpanPlottable::drawBlock(std::int64_t first, int count) {
    const auto size = static_cast<std::size_t>(count);
    // Without any curve the places still have to be wiped.
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        const std::span<Column> columns(columns_.data() + i * kBlock, size);
        const TimeSeries* series = i < curves_.size() ? state_.seriesOf(curves_[i]) : nullptr;
        // Overwritten while it was read: older than the ring, so gone.
        if (series == nullptr ||
            !series->columns(startOf(first, basis_.columnWidth), basis_.columnWidth, columns))
            std::fill(columns.begin(), columns.end(), Column{});
        const int colour = i < curves_.size() ? curves_[i].colour : 0;
        spans_[i] = {curveColour(colour, basis_.dark).rgba(), columns};
    }
    image_.draw(ring_.placeOf(first), spans_, ValueRows(basis_.range, basis_.rows));
    drawnColumns_ += size;
}

}  // namespace kickstand::ui
