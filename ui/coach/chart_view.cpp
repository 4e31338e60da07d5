#include "ui/coach/chart_view.h"

#include <QPainter>
#include <algorithm>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {
namespace {

constexpr double kStateHeight = 36;
constexpr double kArrow = 24;
constexpr double kTimerHeight = 36;
constexpr double kBarHeight = 4;
constexpr std::size_t kMostTimers = 4;

}  // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("State chart"));
}

void ChartView::show(std::vector<ChartState> states, std::vector<ChartTimer> timers) {
    states_ = std::move(states);
    timers_ = std::move(timers);
    QStringList words;
    for (const ChartState& state : states_) {
        if (state.current) words << tr("State: %1").arg(state.name);
    }
    for (const ChartTimer& timer : timers_)
        words << tr("%1 in %2 s").arg(timer.name).arg(timer.left_s, 0, 'f', 1);
    setAccessibleDescription(words.join(QStringLiteral(", ")));
    update();
}

void ChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF all = QRectF(rect()).adjusted(1, 1, -1, -1);
    drawStates(painter, QRectF(all.left(), all.top(), all.width(), kStateHeight));
    drawTimers(painter,
               QRectF(all.left(), all.top() + kStateHeight + metrics::kPadding, all.width(), kTimerHeight));
}

void ChartView::drawStates(QPainter& painter, const QRectF& row) {
    if (states_.empty()) return;
    const Tokens& tokens = tokensOf(palette());
    const auto count = static_cast<double>(states_.size());
    const double width = (row.width() - kArrow * (count - 1)) / count;
    double left = row.left();
    painter.setFont(textFont(metrics::kSmallTextSize));
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const ChartState& state = states_[i];
        const QRectF box(left, row.top(), width, row.height());
        painter.setPen(QPen(state.current ? tokens.accent : tokens.line, 1));
        painter.setBrush(state.current ? tokens.accentSoft : tokens.surface);
        painter.drawRoundedRect(box, metrics::kControlRadius, metrics::kControlRadius);
        painter.setPen(state.current ? tokens.text : tokens.muted);
        painter.setFont(textFont(metrics::kSmallTextSize, state.current ? QFont::Bold : QFont::Normal));
        painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, state.name);
        if (i + 1 < states_.size()) {
            painter.setPen(QPen(tokens.muted, 1));
            const double middle = box.center().y();
            const QPointF tip(box.right() + kArrow - 4, middle);
            painter.drawLine(QPointF(box.right() + 4, middle), tip);
            painter.drawLine(tip, tip + QPointF(-4, -4));
            painter.drawLine(tip, tip + QPointF(-4, 4));
        }
        left += width + kArrow;
    }
}

void ChartView::drawTimers(QPainter& painter, const QRectF& row) {
    if (timers_.empty()) return;
    const Tokens& tokens = tokensOf(palette());
    const std::size_t shown = std::min(timers_.size(), kMostTimers);
    const double width = row.width() / static_cast<double>(kMostTimers);
    painter.setFont(textFont(metrics::kSmallTextSize));
    for (std::size_t i = 0; i < shown; ++i) {
        const ChartTimer& timer = timers_[i];
        const QRectF place(row.left() + width * static_cast<double>(i), row.top(), width - metrics::kGap,
                           row.height());
        painter.setPen(tokens.muted);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignTop,
                         tr("%1 %2 s").arg(timer.name).arg(timer.left_s, 0, 'f', 1));
        QRectF bar(place.left(), place.bottom() - kBarHeight - 4, place.width(), kBarHeight);
        painter.fillRect(bar, tokens.grid);
        bar.setWidth(bar.width() * std::clamp(timer.over, 0.0, 1.0));
        painter.fillRect(bar, tokens.accent);
    }
}

}  // namespace kickstand::ui
