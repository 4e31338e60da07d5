#include "ui/plot/plot_painter.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/plot/curve_colours.h"
#include "ui/plot/mark_painter.h"
#include "ui/plot/name_places.h"
#include "ui/plot/time_ticks.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

struct PlotText {
    Q_DECLARE_TR_FUNCTIONS(PlotText)
};

constexpr int kNameHeight = 13;
constexpr int kTagHeight = 14;
constexpr int kTagGap = 4;
constexpr double kNear = 5;
constexpr int kTitleLeft = 8;
constexpr int kFlagWidth = 17;
constexpr int kFlagHeight = 15;

QString cursorText(const Cursors& cursors) {
    return PlotText::tr("A \u2192 B  \u0394t %1").arg(durationText(cursors.delta()));
}

double luminanceOf(const QColor& ground) {
    return 0.299 * ground.redF() + 0.587 * ground.greenF() + 0.114 * ground.blueF();
}

}  // namespace

void PlotPainter::paintUnder(QPainter& painter) const {
    for (std::size_t i = 0; i < geometry_.areas.size(); ++i) {
        const ShownArea& shown = state_.areas[i];
        const QRect& rect = geometry_.areas[i];
        painter.setPen(QPen(t_.muted, 1, Qt::DashLine));
        for (const PlotThreshold& threshold : shown.area.thresholds) {
            if (threshold.value <= shown.range.low || threshold.value >= shown.range.high) continue;
            const double y = std::round(geometry_.yOf(i, shown.range, threshold.value)) + 0.5;
            painter.drawLine(QPointF(rect.left(), y), QPointF(rect.right(), y));
        }
    }
}

void PlotPainter::paintOver(QPainter& painter) const {
    if (geometry_.empty()) return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    const bool cursors = state_.cursors.isShown();
    const MarkPainter marks(state_, geometry_, t_, fonts_, marks_,
                            cursors ? deltaPlace().left() - kLaneGap : geometry_.laneEnd());
    marks.paintLines(painter);
    if (cursors) paintCursorLines(painter);
    for (std::size_t i = 0; i < geometry_.areas.size(); ++i) {
        paintNames(painter, i);
        paintEnds(painter, i);
    }
    marks.paintLane(painter);
    if (cursors) paintCursorFlags(painter);
}

void PlotPainter::paintNames(QPainter& painter, std::size_t area) const {
    const ShownArea& shown = state_.areas[area];
    const QRect& rect = geometry_.areas[area];
    const std::vector<QRectF> taken{paintTitle(painter, area), paintTriggerName(painter, area)};
    const TextLook look{t_.muted, t_.surface, 2, kNameHeight, TextGround::Halo};
    painter.setFont(fonts_.text);
    std::vector<NamedLine> lines;
    std::vector<const QString*> names;
    for (const PlotThreshold& threshold : shown.area.thresholds) {
        if (threshold.value <= shown.range.low || threshold.value >= shown.range.high) continue;
        lines.push_back({std::round(geometry_.yOf(area, shown.range, threshold.value)),
                         static_cast<double>(textWidth(fonts_.text, threshold.label, look.padding))});
        names.push_back(&threshold.label);
    }
    const QRectF room = QRectF(rect).adjusted(kTitleLeft - look.padding, 0, 0, 0);
    const auto places = placeNames(lines, kNameHeight, room, taken);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i]) drawText(painter, places[i]->topLeft(), *names[i], look);
    }
}

QRectF PlotPainter::paintTitle(QPainter& painter, std::size_t area) const {
    const TextLook look{t_.text, t_.surface, 2, kNameHeight, TextGround::Halo};
    const QString& title = state_.areas[area].area.title;
    const QPointF at = geometry_.areas[area].topLeft() + QPointF(kTitleLeft - look.padding, 1);
    painter.setFont(fonts_.strong);
    drawText(painter, at, title, look);
    return {at, QSizeF(textWidth(fonts_.strong, title, look.padding), look.height)};
}

std::optional<double> PlotPainter::triggerLevel(std::size_t area) const {
    const QRect& rect = geometry_.areas[area];
    const double y = std::round(geometry_.yOf(area, state_.areas[area].range, state_.trigger->level)) + 0.5;
    return y < rect.top() || y > rect.bottom() ? std::nullopt : std::optional(y);
}

QRectF PlotPainter::paintTriggerName(QPainter& painter, std::size_t area) const {
    if (!state_.trigger) return {};
    const auto curve = std::find_if(state_.curves.begin(), state_.curves.end(), [&](const PlotCurve& c) {
        return c.signal == state_.trigger->signal && static_cast<std::size_t>(c.area) == area;
    });
    const auto y = curve == state_.curves.end() ? std::nullopt : triggerLevel(area);
    if (!y) return {};
    const QRect& rect = geometry_.areas[area];
    painter.setPen(QPen(t_.accent, 1, Qt::DashDotLine));
    painter.drawLine(QPointF(rect.left(), *y), QPointF(rect.right(), *y));
    const bool rising = state_.trigger->edge == Edge::Rising;
    const QString text = PlotText::tr("trigger %1 %2")
                             .arg(curve->tag, rising ? QStringLiteral("\u2191") : QStringLiteral("\u2193"));
    const TextLook look{t_.accent, t_.surface, 2, kNameHeight, TextGround::Halo};
    const int width = textWidth(fonts_.text, text, look.padding);
    const double above = *y - 0.5 - kNameHeight;
    const QPointF at(rect.right() - width - 2, above < rect.top() ? *y + 1.5 : above);
    painter.setFont(fonts_.text);
    drawText(painter, at, text, look);
    return {at, QSizeF(width, look.height)};
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
        const QColor ink = last ? t_.text : luminanceOf(colour) > 0.5 ? Qt::black : Qt::white;
        drawText(painter, QPointF(x, std::round(places[i] - kTagHeight / 2.0)), text,
                 {ink, last ? t_.grid : colour, 4, kTagHeight - 1});
    }
}

void PlotPainter::paintCursorLines(QPainter& painter) const {
    for (int i = 0; i < Cursors::kCount; ++i) {
        const TimePoint at = state_.cursors.at(i);
        if (at < state_.view.begin() || at > state_.view.end()) continue;
        const double x = std::floor(geometry_.xOf(state_.view, at));
        for (const QRect& rect : geometry_.areas)
            painter.fillRect(QRectF(x, rect.top(), 1, rect.height()), t_.accent);
    }
}

QRectF PlotPainter::deltaPlace() const {
    const double width = textWidth(fonts_.number, cursorText(state_.cursors), 0);
    return {geometry_.laneEnd() - width, geometry_.laneRowTop(geometry_.laneRows - 1), width,
            static_cast<double>(kLaneRowHeight)};
}

void PlotPainter::paintCursorFlags(QPainter& painter) const {
    const QRect& bottom = geometry_.areas.back();
    painter.setFont(fonts_.number);
    drawText(painter, deltaPlace().topLeft(), cursorText(state_.cursors),
             {t_.accent, t_.surface, 0, kLaneRowHeight});
    // On the axis, where the labels of times make room.
    std::vector<std::pair<double, int>> seen;
    for (int i = 0; i < Cursors::kCount; ++i) {
        const TimePoint at = state_.cursors.at(i);
        if (at >= state_.view.begin() && at <= state_.view.end())
            seen.emplace_back(std::floor(geometry_.xOf(state_.view, at)), i);
    }
    std::sort(seen.begin(), seen.end());
    std::vector<double> wanted;
    wanted.reserve(seen.size());
    for (const auto& [x, cursor] : seen)
        wanted.push_back(x + 0.5);
    const auto places =
        spreadLabels(wanted, kFlagWidth + 1, bottom.left() - kFlagWidth, bottom.right() + kFlagWidth);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool active = seen[i].second == state_.cursors.active();
        const QRectF flag(std::floor(places[i] - kFlagWidth / 2.0), bottom.bottom() + 2, kFlagWidth,
                          kFlagHeight);
        painter.fillRect(flag, active ? t_.accent : t_.accentSoft);
        painter.setPen(active ? t_.onAccent : t_.accent);
        painter.drawText(flag, Qt::AlignCenter,
                         seen[i].second == 0 ? QStringLiteral("A") : QStringLiteral("B"));
    }
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
