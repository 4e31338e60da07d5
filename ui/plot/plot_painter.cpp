#include "ui/plot/plot_painter.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmapCache>
#include <algorithm>
#include <cmath>

#include "ui/plot/curve_colours.h"
#include "ui/plot/time_ticks.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

struct PlotText {
    Q_DECLARE_TR_FUNCTIONS(PlotText)
};

constexpr int kFontSize = 11;
constexpr int kLabelHeight = 15;
constexpr int kTagHeight = 14;
constexpr int kTagGap = 4;
constexpr double kNear = 5;
constexpr int kTitleLeft = 8;

/// Text on the plot's own ground, so that curves do not run through it.
void drawLabel(QPainter& painter, const QRectF& rect, const QString& text, const QColor& ink,
               const QColor& ground, Qt::Alignment alignment = Qt::AlignLeft) {
    QRectF used = painter.boundingRect(rect, alignment | Qt::AlignVCenter | Qt::TextSingleLine, text);
    painter.fillRect(used.adjusted(-2, 0, 2, 0).toAlignedRect(), ground);
    painter.setPen(ink);
    painter.drawText(rect, static_cast<int>(alignment | Qt::AlignVCenter) | Qt::TextSingleLine, text);
}

QString cursorText(const Cursors& cursors) {
    return PlotText::tr("A \u2192 B  \u0394t %1").arg(durationText(cursors.delta()));
}

double luminanceOf(const QColor& ground) {
    return 0.299 * ground.redF() + 0.587 * ground.greenF() + 0.114 * ground.blueF();
}

/// A label in its box. Text is laid out anew whenever it is drawn, so that the same few labels, many times a
/// second, are kept as pictures.
QPixmap tagPicture(const QPainter& painter, const QString& text, const QColor& fill, QColor ink) {
    if (!ink.isValid()) ink = luminanceOf(fill) > 0.5 ? Qt::black : Qt::white;
    const double ratio = painter.device()->devicePixelRatioF();
    const QString key = QStringLiteral("plot-tag/%1/%2/%3/%4").arg(text, fill.name(), ink.name()).arg(ratio);
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) return picture;
    const QSize size(QFontMetrics(painter.font()).horizontalAdvance(text) + 8, kTagHeight - 1);
    picture = QPixmap(size * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(fill);
    QPainter inner(&picture);
    inner.setFont(painter.font());
    inner.setPen(ink);
    inner.drawText(QRect(QPoint(), size), Qt::AlignCenter, text);
    inner.end();
    QPixmapCache::insert(key, picture);
    return picture;
}

}  // namespace

PlotFonts plotFonts() {
    return {textFont(kFontSize), textFont(kFontSize, QFont::DemiBold),
            numberFont(kFontSize, QFont::DemiBold)};
}

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
        if (y <= areas[i].bottom() + 4) return static_cast<int>(i);
    }
    return static_cast<int>(areas.size()) - 1;
}

void PlotPainter::paintUnder(QPainter& painter) const {
    painter.setFont(fonts_.text);
    for (std::size_t i = 0; i < geometry_.areas.size(); ++i)
        paintThresholds(painter, i);
}

void PlotPainter::paintThresholds(QPainter& painter, std::size_t area) const {
    const ShownArea& shown = state_.areas[area];
    const QRect& rect = geometry_.areas[area];
    double before = rect.top() + kLabelHeight;
    for (const PlotThreshold& threshold : shown.area.thresholds) {
        if (threshold.value <= shown.range.low || threshold.value >= shown.range.high) continue;
        const double y = std::round(geometry_.yOf(area, shown.range, threshold.value)) + 0.5;
        painter.setPen(QPen(t_.muted, 1, Qt::DashLine));
        painter.drawLine(QPointF(rect.left(), y), QPointF(rect.right(), y));
        // Thresholds come from the highest down; where labels would touch, the line alone has to do.
        if (y - kLabelHeight < before - 1) continue;
        before = y;
        drawLabel(painter,
                  QRectF(rect.left() + kTitleLeft, y - kLabelHeight, rect.width() - 16, kLabelHeight),
                  threshold.label, t_.muted, t_.surface);
    }
}

void PlotPainter::paintOver(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setFont(fonts_.text);
    paintMarks(painter);
    for (std::size_t i = 0; i < geometry_.areas.size(); ++i) {
        paintTitle(painter, i);
        paintEnds(painter, i);
    }
    paintTrigger(painter);
    paintCursors(painter);
}

void PlotPainter::paintTitle(QPainter& painter, std::size_t area) const {
    const QRect& rect = geometry_.areas[area];
    painter.setFont(fonts_.strong);
    drawLabel(painter, QRectF(rect.left() + kTitleLeft, rect.top() + 1, rect.width(), kLabelHeight),
              state_.areas[area].area.title, t_.text, t_.surface);
    painter.setFont(fonts_.text);
}

void PlotPainter::paintEnds(QPainter& painter, std::size_t area) const {
    struct End {
        double y;
        const PlotCurve* curve;
    };
    const QRect& rect = geometry_.areas[area];
    const TimePoint at = std::min(state_.view.now(), state_.view.end() - Duration(1));
    const double x = std::max(geometry_.xOf(state_.view, at) + kTagGap, static_cast<double>(rect.left()));
    std::vector<End> ends;
    for (const PlotCurve& curve : state_.curves) {
        const TimeSeries* series =
            static_cast<std::size_t>(curve.area) == area ? state_.seriesOf(curve) : nullptr;
        if (series == nullptr) continue;
        const auto held = series->at(at);
        if (!held) continue;
        const double y = geometry_.yOf(area, state_.areas[area].range, static_cast<double>(held->value));
        if (y >= rect.top() - 1 && y <= rect.bottom() + 1) ends.push_back({y, &curve});
    }
    // Values that are almost the same keep their order: noise does not shuffle their labels.
    const auto step = [](const End& end) { return std::round(end.y * 2 / kTagHeight); };
    std::stable_sort(ends.begin(), ends.end(),
                     [step](const End& a, const End& b) { return step(a) < step(b); });
    std::vector<double> wanted;
    wanted.reserve(ends.size());
    for (const End& end : ends)
        wanted.push_back(end.y);
    const std::vector<double> places = spreadLabels(wanted, kTagHeight, rect.top(), rect.bottom() + 1);
    painter.setFont(fonts_.number);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const QColor colour = curveColour(ends[i].curve->colour, t_.dark);
        const bool last = i + 1 == places.size() && places.size() < ends.size();
        const QString text = last ? QStringLiteral("+%1").arg(ends.size() - i) : ends[i].curve->tag;
        const QPixmap tag = tagPicture(painter, text, last ? t_.grid : colour, last ? t_.text : QColor());
        painter.drawPixmap(QPointF(x, std::round(places[i] - kTagHeight / 2.0)), tag);
    }
    painter.setFont(fonts_.text);
}

void PlotPainter::line(QPainter& painter, double x, const QColor& colour, Qt::PenStyle style) const {
    painter.setPen(QPen(colour, 1, style));
    const double column = std::floor(x) + 0.5;
    for (const QRect& rect : geometry_.areas)
        painter.drawLine(QPointF(column, rect.top()), QPointF(column, rect.bottom()));
}

void PlotPainter::paintMarks(QPainter& painter) const {
    if (state_.store == nullptr || !state_.describeMark || geometry_.empty()) return;
    const auto marks = state_.store->marks().between(state_.view.begin(), state_.view.end());
    std::vector<ShownMark> shown;
    double before = -1;
    for (const Mark& mark : marks.value_or(std::vector<Mark>{})) {
        const double x = std::floor(geometry_.xOf(state_.view, mark.time));
        // Of marks in one column the first is drawn; hovering tells of the others.
        if (x == before) continue;
        auto words = state_.describeMark(mark);
        if (!words) continue;
        before = x;
        line(painter, x, words->danger ? t_.danger : t_.muted, Qt::DotLine);
        shown.push_back({x, *std::move(words)});
    }
    paintMarkLabels(painter, shown);
}

void PlotPainter::paintMarkLabels(QPainter& painter, const std::vector<ShownMark>& marks) const {
    const QRect& top = geometry_.areas.front();
    // The area's title stands at the left, the time between the cursors at the right.
    const QFontMetrics strong(fonts_.strong);
    double free = top.left() + kTitleLeft + strong.horizontalAdvance(state_.areas.front().area.title) + 8;
    double end = top.right();
    if (state_.cursors.isShown()) end -= strong.horizontalAdvance(cursorText(state_.cursors)) + 20;
    for (const ShownMark& mark : marks) {
        const int width = painter.fontMetrics().horizontalAdvance(mark.words.label);
        // What has just happened is told to the left of its line, where there is room for it.
        const double x = mark.x + kTagGap + width > end ? mark.x - kTagGap - width : mark.x + kTagGap;
        if (x < free || x + width > end) continue;
        drawLabel(painter, QRectF(x, top.top() + 1, width + 2, kLabelHeight), mark.words.label,
                  mark.words.danger ? t_.danger : t_.text, t_.surface);
        free = std::max(x + width, mark.x) + 2.0 * kTagGap;
    }
}

void PlotPainter::paintTrigger(QPainter& painter) const {
    if (!state_.trigger) return;
    const PlotTrigger& trigger = *state_.trigger;
    for (const PlotCurve& curve : state_.curves) {
        if (curve.signal != trigger.signal) continue;
        const auto area = static_cast<std::size_t>(curve.area);
        const QRect& rect = geometry_.areas[area];
        const double y = std::round(geometry_.yOf(area, state_.areas[area].range, trigger.level)) + 0.5;
        if (y < rect.top() || y > rect.bottom()) continue;
        painter.setPen(QPen(t_.accent, 1, Qt::DashDotLine));
        painter.drawLine(QPointF(rect.left(), y), QPointF(rect.right(), y));
        const QString arrow =
            trigger.edge == Edge::Rising ? QStringLiteral("\u2191") : QStringLiteral("\u2193");
        drawLabel(painter, QRectF(rect.left(), y - kLabelHeight, rect.width() - 4, kLabelHeight),
                  PlotText::tr("trigger %1 %2").arg(curve.tag, arrow), t_.accent, t_.surface, Qt::AlignRight);
    }
    if (trigger.state == PlotTrigger::State::Caught)
        line(painter, geometry_.xOf(state_.view, trigger.caughtAt), t_.accent, Qt::DashDotLine);
}

void PlotPainter::paintCursors(QPainter& painter) const {
    if (!state_.cursors.isShown() || geometry_.empty()) return;
    const QRect& bottom = geometry_.areas.back();
    painter.setFont(fonts_.number);
    for (int i = 0; i < Cursors::kCount; ++i) {
        const TimePoint at = state_.cursors.at(i);
        if (at < state_.view.begin() || at > state_.view.end()) continue;
        const double x = std::floor(geometry_.xOf(state_.view, at));
        line(painter, x, t_.accent, Qt::SolidLine);
        const bool active = i == state_.cursors.active();
        const QString name = i == 0 ? QStringLiteral("A") : QStringLiteral("B");
        const QRectF flag(x - 8, bottom.bottom() - kLabelHeight, 17, kLabelHeight);
        painter.fillRect(flag, active ? t_.accent : t_.accentSoft);
        painter.setPen(active ? t_.onAccent : t_.accent);
        painter.drawText(flag, Qt::AlignCenter, name);
    }
    const QString text = cursorText(state_.cursors);
    const QRect& top = geometry_.areas.front();
    drawLabel(painter, QRectF(top.left(), top.top() + 1, top.width() - 4, kLabelHeight), text, t_.accent,
              t_.surface, Qt::AlignRight);
}

std::optional<Mark> markNear(const PlotState& state, const PlotGeometry& geometry, double x) {
    if (state.store == nullptr || !state.describeMark || geometry.empty()) return std::nullopt;
    const TimePoint from = geometry.timeAt(state.view, x - kNear);
    const TimePoint to = geometry.timeAt(state.view, x + kNear + 1);
    const auto marks = state.store->marks().between(from, to);
    std::optional<Mark> best;
    double distance = kNear + 1;
    for (const Mark& mark : marks.value_or(std::vector<Mark>{})) {
        const double away = std::abs(geometry.xOf(state.view, mark.time) - x);
        if (away >= distance || !state.describeMark(mark)) continue;
        distance = away;
        best = mark;
    }
    return best;
}

std::vector<double> spreadLabels(std::vector<double> wanted, double height, double top, double bottom) {
    const auto room = static_cast<std::size_t>(std::max((bottom - top) / height, 0.0));
    wanted.resize(std::min(wanted.size(), room));
    double next = top + height / 2;
    for (double& place : wanted) {
        place = std::max(place, next);
        next = place + height;
    }
    double last = bottom - height / 2;
    for (auto place = wanted.rbegin(); place != wanted.rend(); ++place) {
        *place = std::min(*place, last);
        last = *place - height;
    }
    return wanted;
}

}  // namespace kickstand::ui
