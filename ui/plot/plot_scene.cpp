#include "ui/plot/plot_scene.h"

#include <algorithm>
#include <numeric>

#include "ui/plot/span_plottable.h"
#include "ui/plot/time_ticks.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kLeftRoom = 44;
constexpr int kRightRoom = 40;
constexpr int kTopRoom = 4;
/// Labels of neighbouring areas do not touch.
constexpr int kBetween = 6;
constexpr int kBottomRoom = 20;
/// The lane has a row of words for so many pixels of the plot's height.
constexpr int kHeightOfLaneRow = 75;
constexpr int kMostLaneRows = 3;
constexpr int kFontSize = 11;
/// No more than one label in so many pixels.
constexpr int kTimeTickRoom = 90;
constexpr int kValueTickRoom = 34;

double coordinateOf(TimePoint time) {
    return seconds(time.time_since_epoch());
}

/// Puts round times on the axis: counted back from the present while it is followed, else as the clock on the
/// wall has them.
class TimeTicker final : public QCPAxisTicker {
  public:
    TimeTicker(const QCustomPlot& plot, const PlotState& state) : plot_(plot), state_(state) {}

    void generate(const QCPRange&, const QLocale&, QChar, int, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* labels) override {
        const TimeView& view = state_.view;
        const int most = std::max(2, plot_.width() / kTimeTickRoom);
        const Duration step = tickStep(view.end() - view.begin(), most);
        const std::vector<TimeTick> made =
            view.isFollowing() ? ticksBefore(view.begin(), view.end(), step)
                               : clockTicks(view.begin(), view.end(), step, state_.clock.wall(view.begin()));
        ticks.clear();
        if (subTicks != nullptr) subTicks->clear();
        if (labels != nullptr) labels->clear();
        for (const TimeTick& tick : made) {
            ticks.append(coordinateOf(tick.at));
            if (labels != nullptr) labels->append(isUnderCursor(tick) ? QString() : tick.label);
        }
    }

  private:
    /// The flags of the cursors stand where labels do.
    bool isUnderCursor(const TimeTick& tick) const {
        const Cursors& cursors = state_.cursors;
        const Duration reach = state_.view.columnWidth() * (kTimeTickRoom / 2);
        return cursors.isShown() && cursors.nearest(tick.at, reach) >= 0;
    }

    const QCustomPlot& plot_;
    const PlotState& state_;
};

/// What PlotPainter draws, as a part of the plot.
class PaintedLayer final : public QCPLayerable {
  public:
    PaintedLayer(QCustomPlot& plot, const char* layer, std::function<void(QPainter&)> paint)
        : QCPLayerable(&plot, QString::fromLatin1(layer)), paint_(std::move(paint)) {}

  protected:
    void applyDefaultAntialiasingHint(QCPPainter*) const override {}
    QRect clipRect() const override { return parentPlot()->viewport(); }
    void draw(QCPPainter* painter) override { paint_(*painter); }

  private:
    std::function<void(QPainter&)> paint_;
};

void colourAxis(QCPAxis& axis, const Tokens& t) {
    axis.setBasePen(QPen(t.line, 1));
    axis.setTickPen(Qt::NoPen);
    axis.setTickLabelColor(t.muted);
    axis.setTickLabelFont(numberFont(kFontSize));
    axis.grid()->setPen(QPen(t.grid, 1));
    axis.grid()->setZeroLinePen(Qt::NoPen);
}

}  // namespace

PlotScene::PlotScene(QCustomPlot& plot, PlotState& state)
    : plot_(plot), state_(state), timeTicker_(new TimeTicker(plot, state)) {
    plot.setNoAntialiasingOnDrag(true);
    plot.setAntialiasedElements(QCP::aeNone);
    plot.setPlottingHints(QCP::phCacheLabels);
    // One buffer for everything: each more is one more copy of the widget a frame.
    plot.layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmLogical);
    plot.addLayer(QStringLiteral("under"), plot.layer(QStringLiteral("grid")));
    plot.addLayer(QStringLiteral("over"), plot.layer(QStringLiteral("axes")));
    const auto painted = [this](void (PlotPainter::*paint)(QPainter&) const) {
        return [this, paint](QPainter& painter) {
            const PlotGeometry geometry = this->geometry();
            const PlotPainter plotPainter(state_, geometry, tokensOf(plot_.palette()), fonts_, marks_);
            (plotPainter.*paint)(painter);
        };
    };
    // The plot owns them.
    new PaintedLayer(plot, "under", painted(&PlotPainter::paintUnder));
    new PaintedLayer(plot, "over", painted(&PlotPainter::paintOver));
    rebuild();
    plot.installEventFilter(this);
    connect(&plot, &QCustomPlot::beforeReplot, this, &PlotScene::showRanges);
}

void PlotScene::rebuild() {
    plot_.clearPlottables();
    plot_.plotLayout()->clear();
    rects_.clear();
    spans_.clear();
    const auto count = static_cast<int>(state_.areas.size());
    for (int i = 0; i < count; ++i)
        addArea(i, i + 1 == count);
    plot_.plotLayout()->setRowSpacing(0);
    shared_ = {};
    recolour();
}

void PlotScene::addArea(int index, bool last) {
    auto* rect = new QCPAxisRect(&plot_, false);
    rect->setAutoMargins(QCP::msNone);
    rect->setMinimumSize(0, 0);
    rect->setRangeDrag({});
    rect->setRangeZoom({});
    QCPAxis* time = rect->addAxis(QCPAxis::atBottom);
    QCPAxis* value = rect->addAxis(QCPAxis::atLeft);
    time->setTicker(timeTicker_);
    time->setTickLabels(last);
    for (QCPAxis* axis : {time, value}) {
        axis->setLayer(QStringLiteral("axes"));
        axis->grid()->setLayer(QStringLiteral("grid"));
        axis->setSubTicks(false);
        axis->setTickLength(0);
        axis->setTickLabelPadding(4);
        axis->grid()->setVisible(true);
        axis->grid()->setSubGridVisible(false);
    }
    value->setNumberFormat(QStringLiteral("g"));
    plot_.plotLayout()->addElement(index, 0, rect);
    rects_.push_back(rect);
    spans_.push_back(new SpanPlottable(time, value, state_, index));
}

void PlotScene::invalidate() {
    for (SpanPlottable* span : spans_)
        span->invalidate();
    marks_.forget(fonts_.text);
}

bool PlotScene::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        recolour();
        draw();
    }
    return QObject::eventFilter(watched, event);
}

void PlotScene::recolour() {
    const Tokens& t = tokensOf(plot_.palette());
    fonts_ = plotFonts();
    marks_.forget(fonts_.text);
    plot_.setBackground(QBrush(t.surface));
    for (QCPAxisRect* rect : rects_) {
        for (QCPAxis* axis : rect->axes())
            colourAxis(*axis, t);
    }
}

int PlotScene::columns() const {
    const double ratio = plot_.devicePixelRatioF();
    const int width = plot_.width() - kLeftRoom - kRightRoom;
    return std::max(1, static_cast<int>(width * ratio / strokeOf(ratio)));
}

void PlotScene::showRanges() {
    shareHeight();
    state_.view.setColumns(columns());
    const double begin = coordinateOf(state_.view.begin());
    const double end = coordinateOf(state_.view.end());
    for (std::size_t i = 0; i < rects_.size(); ++i) {
        const ValueRange& range = state_.areas[i].range;
        rects_[i]->axis(QCPAxis::atBottom)->setRange(begin, end);
        QCPAxis* value = rects_[i]->axis(QCPAxis::atLeft);
        value->setRange(range.low, range.high);
        value->ticker()->setTickCount(std::max(2, rects_[i]->height() / kValueTickRoom));
    }
}

int PlotScene::laneRows() const {
    return std::clamp(plot_.height() / kHeightOfLaneRow, 1, kMostLaneRows);
}

/// Areas are equally high, though the first has the lane above it and the last the axis below it.
void PlotScene::shareHeight() {
    if (rects_.empty() || plot_.size() == shared_) return;
    shared_ = plot_.size();
    const auto count = static_cast<int>(rects_.size());
    std::vector<int> rooms;
    for (int i = 0; i < count; ++i) {
        const int top = i == 0 ? laneHeight(laneRows()) : kTopRoom;
        const int bottom = i + 1 == count ? kBottomRoom : kBetween;
        rects_[static_cast<std::size_t>(i)]->setMargins(QMargins(kLeftRoom, top, kRightRoom, bottom));
        rooms.push_back(top + bottom);
    }
    const int all = std::accumulate(rooms.begin(), rooms.end(), 0);
    const double area = std::max((plot_.height() - all) / static_cast<double>(count), 1.0);
    QList<double> heights;
    std::transform(rooms.begin(), rooms.end(), std::back_inserter(heights),
                   [area](int room) { return area + room; });
    plot_.plotLayout()->setRowStretchFactors(heights);
}

void PlotScene::draw() {
    plot_.replot(QCustomPlot::rpQueuedRefresh);
}

PlotGeometry PlotScene::geometry() const {
    PlotGeometry geometry;
    geometry.labelRoom = kRightRoom;
    geometry.laneRows = laneRows();
    geometry.areas.reserve(rects_.size());
    for (const QCPAxisRect* rect : rects_)
        geometry.areas.emplace_back(rect->topLeft(), rect->size());
    return geometry;
}

std::uint64_t PlotScene::drawnColumns() const {
    std::uint64_t sum = 0;
    for (const SpanPlottable* span : spans_)
        sum += span->drawnColumns();
    return sum;
}

}  // namespace kickstand::ui
