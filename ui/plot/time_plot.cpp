#include "ui/plot/time_plot.h"

#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "ui/plot/plot_input.h"
#include "ui/plot/plot_scene.h"

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

constexpr auto kFrame = 16ms;
constexpr auto kRangesInterval = 250ms;
/// Values that hardly change are shown at this part of the usual range at least.
constexpr double kLeastFit = 0.02;

}  // namespace

TimePlot::TimePlot(PlotClock clock, QWidget* parent)
    : QWidget(parent), state_(std::make_unique<PlotState>()), canvas_(new QCustomPlot(this)) {
    state_->clock = std::move(clock);
    state_->view.advance(state_->clock.now());
    scene_ = std::make_unique<PlotScene>(*canvas_, *state_);
    canvas_->setObjectName(QStringLiteral("plot"));
    canvas_->setFocusPolicy(Qt::StrongFocus);
    canvas_->setMouseTracking(true);
    canvas_->setAccessibleName(tr("Curves over time"));
    setFocusProxy(canvas_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(canvas_);
    new PlotInput(*this, *canvas_);
    frames_.setTimerType(Qt::PreciseTimer);
    connect(&frames_, &QTimer::timeout, this, &TimePlot::frame);
    connect(&ranges_, &QTimer::timeout, this, &TimePlot::widenUsual);
}

TimePlot::~TimePlot() = default;

void TimePlot::setStore(std::shared_ptr<const TelemetryStore> store) {
    if (store == state_->store) return;
    disarm();
    state_->store = std::move(store);
    scene_->invalidate();
    dirty_ = true;
}

void TimePlot::setContents(const std::vector<PlotArea>& areas, std::vector<PlotCurve> curves) {
    std::vector<ShownArea> shown;
    shown.reserve(areas.size());
    for (const PlotArea& area : areas) {
        const auto before = std::find_if(state_->areas.begin(), state_->areas.end(),
                                         [&](const ShownArea& s) { return s.area.title == area.title; });
        shown.push_back(before != state_->areas.end() ? ShownArea{area, before->range, before->usual}
                                                      : ShownArea{area, area.usual, true});
    }
    state_->areas = std::move(shown);
    state_->curves = std::move(curves);
    state_->keyArea = std::clamp(state_->keyArea, 0, std::max(static_cast<int>(areas.size()) - 1, 0));
    const auto shows = [this](SignalId signal) {
        return std::any_of(state_->curves.begin(), state_->curves.end(),
                           [signal](const PlotCurve& curve) { return curve.signal == signal; });
    };
    if (state_->trigger && !shows(state_->trigger->signal)) disarm();
    scene_->rebuild();
    widenUsual();
    changed();
}

void TimePlot::setDescribeMark(DescribeMark describe, CountMarks count) {
    state_->describeMark = std::move(describe);
    state_->countMarks = std::move(count);
    scene_->invalidate();
    dirty_ = true;
}

void TimePlot::changed() {
    dirty_ = true;
    emit viewChanged();
}

void TimePlot::follow() {
    state_->view.advance(state_->clock.now());
    state_->view.follow();
    changed();
}

void TimePlot::pause() {
    state_->view.pause();
    changed();
}

void TimePlot::setSpan(Duration span) {
    state_->view.setSpan(span);
    changed();
}

void TimePlot::zoomTime(double factor, double place) {
    state_->view.zoom(factor, place);
    changed();
}

void TimePlot::panTime(std::int64_t columns) {
    state_->view.pan(columns);
    changed();
}

void TimePlot::showOldest() {
    std::optional<TimePoint> oldest;
    for (const PlotCurve& curve : state_->curves) {
        const TimeSeries* series = state_->seriesOf(curve);
        const auto range = series == nullptr ? tl::unexpected(Miss::NoValue) : series->available();
        if (range && (!oldest || range->coarse < *oldest)) oldest = range->coarse;
    }
    if (!oldest) return;
    state_->view.showFrom(*oldest);
    changed();
}

void TimePlot::zoomValues(int area, double factor, double value) {
    ShownArea& shown = state_->areas[static_cast<std::size_t>(area)];
    shown.range = zoomed(shown.range, factor, value);
    shown.usual = false;
    changed();
}

void TimePlot::panValues(int area, double part) {
    ShownArea& shown = state_->areas[static_cast<std::size_t>(area)];
    shown.range = moved(shown.range, part);
    shown.usual = false;
    changed();
}

void TimePlot::fitValues() {
    for (std::size_t i = 0; i < state_->areas.size(); ++i) {
        ShownArea& shown = state_->areas[i];
        std::optional<SpanStats> all;
        for (const PlotCurve& curve : state_->curves) {
            const auto stats = static_cast<std::size_t>(curve.area) == i ? statsOf(curve) : std::nullopt;
            if (!stats) continue;
            if (!all) all = stats;
            all->min = std::min(all->min, stats->min);
            all->max = std::max(all->max, stats->max);
        }
        if (!all) continue;
        shown.range = around(static_cast<double>(all->min), static_cast<double>(all->max),
                             shown.area.usual.size() * kLeastFit);
        shown.usual = false;
    }
    changed();
}

void TimePlot::usualValues() {
    for (ShownArea& shown : state_->areas) {
        shown.range = shown.area.usual;
        shown.usual = true;
    }
    widenUsual();
    changed();
}

void TimePlot::chooseKeyArea(int area) {
    const int last = static_cast<int>(state_->areas.size()) - 1;
    state_->keyArea = std::clamp(area, 0, std::max(last, 0));
    changed();
}

void TimePlot::widenUsual() {
    for (std::size_t i = 0; i < state_->areas.size(); ++i) {
        ShownArea& shown = state_->areas[i];
        if (!shown.usual) continue;
        double least = shown.area.usual.low;
        double most = shown.area.usual.high;
        for (const PlotCurve& curve : state_->curves) {
            const auto stats = static_cast<std::size_t>(curve.area) == i ? statsOf(curve) : std::nullopt;
            if (!stats) continue;
            least = std::min(least, static_cast<double>(stats->min));
            most = std::max(most, static_cast<double>(stats->max));
        }
        const ValueRange wanted = widened(shown.area.usual, least, most);
        if (wanted == shown.range) continue;
        shown.range = wanted;
        dirty_ = true;
    }
}

void TimePlot::showCursors(bool shown) {
    if (shown) {
        state_->cursors.show(state_->view);
    } else {
        state_->cursors.hide();
    }
    changed();
}

void TimePlot::putCursor(int cursor, TimePoint time) {
    state_->cursors.put(cursor, time);
    changed();
}

void TimePlot::stepCursor(std::int64_t columns) {
    if (!state_->cursors.isShown()) return;
    state_->cursors.step(columns, state_->view);
    changed();
}

void TimePlot::swapCursors() {
    state_->cursors.activate(1 - state_->cursors.active());
    changed();
}

void TimePlot::arm(SignalId signal, Edge edge, double level) {
    state_->trigger = PlotTrigger{signal, edge, level, PlotTrigger::State::Waiting, {}};
    waiting_.reset();
    checkTrigger();
    changed();
}

void TimePlot::disarm() {
    if (!state_->trigger) return;
    state_->trigger.reset();
    waiting_.reset();
    changed();
}

void TimePlot::checkTrigger() {
    if (!state_->trigger || state_->trigger->state != PlotTrigger::State::Waiting) return;
    PlotTrigger& trigger = *state_->trigger;
    if (!waiting_) {
        const TimeSeries* series = state_->store == nullptr ? nullptr : state_->store->find(trigger.signal);
        if (series == nullptr) return;
        waiting_.emplace(*series, trigger.edge, static_cast<float>(trigger.level));
    }
    const auto crossed = waiting_->check();
    if (!crossed) return;
    trigger.state = PlotTrigger::State::Caught;
    trigger.caughtAt = *crossed;
    waiting_.reset();
    state_->view.centre(*crossed);
    changed();
    emit triggered();
}

bool TimePlot::goToMark(bool next) {
    if (state_->store == nullptr || !state_->describeMark) return false;
    const auto marks = state_->store->marks().between(TimePoint::min(), TimePoint::max());
    const Duration width = state_->view.columnWidth();
    const std::int64_t middle = state_->view.middle();
    std::optional<TimePoint> found;
    for (const Mark& mark : marks.value_or(std::vector<Mark>{})) {
        const std::int64_t column = columnAt(mark.time, width);
        if (!(next ? column > middle : column < middle) || !state_->describeMark(mark)) continue;
        found = mark.time;
        if (next) break;
    }
    if (!found) return false;
    state_->view.centre(*found);
    changed();
    return true;
}

std::optional<SpanStats> TimePlot::statsOf(const PlotCurve& curve) const {
    const TimeSeries* series = state_->seriesOf(curve);
    if (series == nullptr) return std::nullopt;
    const auto stats = series->stats(state_->view.begin(), std::min(state_->view.end(), state_->view.now()));
    return stats ? std::optional(*stats) : std::nullopt;
}

std::optional<float> TimePlot::valueAt(const PlotCurve& curve, TimePoint time) const {
    const TimeSeries* series = time > state_->view.now() ? nullptr : state_->seriesOf(curve);
    const auto sample = series == nullptr ? tl::unexpected(Miss::NoValue) : series->at(time);
    return sample ? std::optional(sample->value) : std::nullopt;
}

QPixmap TimePlot::picture() {
    dirty_ = true;
    frame();
    return canvas_->grab();
}

Seen TimePlot::seen() const {
    const TimeView& view = state_->view;
    const std::int64_t present = columnAt(view.now(), view.columnWidth()) + 1;
    const ColumnSpan past = commonOf(view.shown(), {view.shown().first, present});
    Seen seen{view.begin(), view.columnWidth(), {}};
    for (const PlotCurve& curve : state_->curves) {
        const ShownArea& area = state_->areas[static_cast<std::size_t>(curve.area)];
        SeenCurve column{curve.name + QStringLiteral(" [") + area.area.unit + u']', {}};
        column.columns.resize(static_cast<std::size_t>(past.count()));
        const TimeSeries* series = state_->seriesOf(curve);
        if (series == nullptr || !series->columns(view.begin(), view.columnWidth(), column.columns))
            std::fill(column.columns.begin(), column.columns.end(), Column{});
        seen.curves.push_back(std::move(column));
    }
    return seen;
}

TimePlot::Drawn TimePlot::current() const {
    const TimeView& view = state_->view;
    Drawn drawn{view.shown(), view.columnWidth(), columnAt(view.now(), view.columnWidth()), 0, 0};
    // What lies in the past for good looks the same whatever comes.
    constexpr auto kLate = 1s;
    if (view.end() < view.now() - kLate) {
        drawn.present = view.shown().end;
        return drawn;
    }
    for (const PlotCurve& curve : state_->curves) {
        if (const TimeSeries* series = state_->seriesOf(curve)) drawn.samples += series->total();
    }
    if (state_->store != nullptr) drawn.marks = state_->store->marks().total();
    return drawn;
}

void TimePlot::frame() {
    state_->view.advance(state_->clock.now());
    checkTrigger();
    const Drawn now = current();
    if (!dirty_ && now == drawn_) return;
    drawn_ = now;
    dirty_ = false;
    scene_->draw();
}

void TimePlot::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    dirty_ = true;
    frames_.start(kFrame);
    ranges_.start(kRangesInterval);
}

void TimePlot::hideEvent(QHideEvent* event) {
    frames_.stop();
    ranges_.stop();
    QWidget::hideEvent(event);
}

}  // namespace kickstand::ui
