#include "ui/coach/chart_view.h"

#include <QPainter>
#include <algorithm>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {
namespace {

constexpr double kBoxWidth = 112;
constexpr double kBoxHeight = 36;
constexpr double kRowGap = 28;
/// Between the lower row and the line of what goes below it.
constexpr double kLane = 24;
/// An arrow there and the one back stand so far from the middle.
constexpr double kAside = 8;
constexpr double kTip = 4;
constexpr double kTextHeight = 16;
constexpr double kTimerHeight = 20;
constexpr double kTimerWidth = 240;
constexpr double kTimerBar = 4;
constexpr std::size_t kMostTimers = 4;

double columnsOf(const Chart& chart) {
    double columns = 0;
    for (const ChartState& state : chart.states)
        columns = std::max(columns, state.column);
    return std::max(columns, 1.0);
}

/// Lines from place to place, and a tip at the last one.
void drawPath(QPainter& painter, const QPolygonF& path) {
    painter.drawPolyline(path);
    const QPointF end = path.last();
    const QPointF before = path[path.size() - 2];
    const double length = QLineF(before, end).length();
    if (length == 0) return;
    const QPointF along = (end - before) / length * kTip;
    const QPointF across(-along.y(), along.x());
    painter.drawLine(end, end - along + across);
    painter.drawLine(end, end - along - across);
}

void drawText(QPainter& painter, const QRectF& place, Qt::Alignment alignment, const QString& text) {
    painter.drawText(place, static_cast<int>(alignment | Qt::AlignVCenter),
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(place.width())));
}

}  // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("State chart"));
}

void ChartView::show(Chart chart) {
    chart_ = std::move(chart);
    QStringList words;
    for (const ChartState& state : chart_.states) {
        if (state.current) words << tr("State: %1").arg(state.name);
    }
    for (const ChartTimer& timer : chart_.timers)
        words << tr("%1 in %2 s").arg(timer.name).arg(timer.left_s, 0, 'f', 1);
    setAccessibleDescription(words.join(QStringLiteral(", ")));
    update();
}

QRectF ChartView::boxOf(const ChartState& state) const {
    const double step = (width() - kBoxWidth - 2) / columnsOf(chart_);
    return {1 + state.column * step, kTextHeight + state.row * (kBoxHeight + kRowGap), kBoxWidth, kBoxHeight};
}

void ChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont(metrics::kSmallTextSize));
    for (const ChartArrow& arrow : chart_.arrows)
        drawArrow(painter, arrow);
    for (const ChartState& state : chart_.states)
        drawState(painter, state);
    drawTimers(painter);
}

void ChartView::drawState(QPainter& painter, const ChartState& state) const {
    const Tokens& tokens = tokensOf(palette());
    const QRectF box = boxOf(state);
    painter.setPen(QPen(state.current ? tokens.accent : tokens.line, state.current ? 2 : 1));
    painter.setBrush(state.current ? tokens.accentSoft : tokens.surface);
    painter.drawRoundedRect(box, metrics::kControlRadius, metrics::kControlRadius);
    painter.setPen(state.current ? tokens.text : tokens.muted);
    painter.setFont(textFont(metrics::kSmallTextSize, state.current ? QFont::Bold : QFont::Normal));
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, state.name);
}

void ChartView::drawArrow(QPainter& painter, const ChartArrow& arrow) const {
    const ChartState& start = chart_.states[arrow.from];
    const ChartState& end = chart_.states[arrow.to];
    painter.setPen(QPen(tokensOf(palette()).muted, 1));
    painter.setBrush(Qt::NoBrush);
    if (arrow.below) return drawBelow(painter, boxOf(start), boxOf(end), arrow.fires);
    if (start.row == end.row) return drawAcross(painter, boxOf(start), boxOf(end), arrow.fires);
    if (start.row > end.row) return drawUp(painter, boxOf(start), boxOf(end), arrow.fires);
    drawDown(painter, boxOf(start), boxOf(end), arrow.fires);
}

/// To the right in the upper half with its text above, to the left in the lower one with its text below.
void ChartView::drawAcross(QPainter& painter, const QRectF& from, const QRectF& to,
                           const QString& fires) const {
    const bool right = from.left() < to.left();
    const double y = from.center().y() + (right ? -kAside : kAside);
    const QPointF begin(right ? from.right() : from.left(), y);
    const QPointF end(right ? to.left() : to.right(), y);
    drawPath(painter, {begin, end});
    const double left = std::min(begin.x(), end.x()) + kTip;
    const double room = std::abs(end.x() - begin.x()) - 2 * kTip;
    drawText(painter, {left, right ? y - kTextHeight : y, room, kTextHeight}, Qt::AlignHCenter, fires);
}

void ChartView::drawDown(QPainter& painter, const QRectF& from, const QRectF& to,
                         const QString& fires) const {
    const double x = from.center().x() - kAside;
    drawPath(painter, {{x, from.bottom()}, {x, to.top()}});
    drawText(painter, {x + kTip * 2, from.bottom(), kBoxWidth, to.top() - from.bottom()}, Qt::AlignLeft,
             fires);
}

/// Along the lower row, and up below the left end of the state that it leads to.
void ChartView::drawUp(QPainter& painter, const QRectF& from, const QRectF& to, const QString& fires) const {
    const double y = from.center().y();
    const double x = to.left() + kAside * 2;
    drawPath(painter, {{from.right(), y}, {x, y}, {x, to.bottom()}});
    drawText(painter, {from.right() + kTip, y - kTextHeight, x - from.right() - 2 * kTip, kTextHeight},
             Qt::AlignHCenter, fires);
}

void ChartView::drawBelow(QPainter& painter, const QRectF& from, const QRectF& to,
                          const QString& fires) const {
    const double y = kTextHeight + 2 * kBoxHeight + kRowGap + kLane;
    const double begin = from.left() + kAside * 4;
    const double end = to.center().x() - kAside;
    drawPath(painter, {{begin, from.bottom()}, {begin, y}, {end, y}, {end, to.bottom()}});
    drawText(painter, {end + kTip * 2, y - kTextHeight, begin - end - kTip * 4, kTextHeight}, Qt::AlignRight,
             fires);
}

void ChartView::drawTimers(QPainter& painter) const {
    const Tokens& tokens = tokensOf(palette());
    const double step = (width() - kBoxWidth - 2) / columnsOf(chart_);
    const double left = 1 + chart_.timersColumn * step;
    const double room = std::min(kTimerWidth, (chart_.timersEnd - chart_.timersColumn) * step);
    const std::size_t shown = std::min(chart_.timers.size(), kMostTimers);
    painter.setFont(textFont(metrics::kSmallTextSize));
    for (std::size_t i = 0; i < shown; ++i) {
        const ChartTimer& timer = chart_.timers[i];
        const QRectF place(left, kTextHeight + kBoxHeight + kTip + static_cast<double>(i) * kTimerHeight,
                           room, kTimerHeight);
        painter.setPen(tokens.muted);
        drawText(painter, place.adjusted(0, 0, 0, -kTimerBar), Qt::AlignLeft, timer.name);
        drawText(painter, place.adjusted(0, 0, 0, -kTimerBar), Qt::AlignRight,
                 tr("%1 s").arg(timer.left_s, 0, 'f', 1));
        QRectF bar(place.left(), place.bottom() - kTimerBar, place.width(), 2);
        painter.fillRect(bar, tokens.grid);
        bar.setWidth(bar.width() * std::clamp(timer.over, 0.0, 1.0));
        painter.fillRect(bar, tokens.accent);
    }
}

}  // namespace kickstand::ui
