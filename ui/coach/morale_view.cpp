#include "ui/coach/morale_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {
namespace {

constexpr double kRing = 6;
constexpr int kNumberSize = 32;
/// How a painter counts angles: in sixteenths of a degree, from the right, counterclockwise.
constexpr int kTop = 90 * 16;
constexpr int kWhole = 360 * 16;

}  // namespace

MoraleView::MoraleView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Morale"));
    setToolTip(tr("Morale of the crew, and its last minute; at −10 the crew mutinies"));
}

QString MoraleView::text() const {
    return morale_ ? signedNumber(*morale_) : QStringLiteral("–");
}

void MoraleView::show(std::optional<int> morale, std::optional<double> left, std::vector<float> history) {
    morale_ = morale;
    left_ = left;
    history_ = std::move(history);
    setAccessibleDescription(text());
    update();
}

void MoraleView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = height();
    drawNumber(painter, QRectF(0, 0, side, side));
    const double left = side + metrics::kPadding;
    drawHistory(painter, QRectF(left, metrics::kGap, width() - left, side - 2 * metrics::kGap));
}

void MoraleView::drawNumber(QPainter& painter, const QRectF& place) {
    const Tokens& tokens = tokensOf(palette());
    const QRectF ring = place.adjusted(kRing, kRing, -kRing, -kRing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens.grid, kRing, Qt::SolidLine, Qt::FlatCap));
    painter.drawEllipse(ring);
    if (left_) {
        painter.setPen(QPen(tokens.warn, kRing, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(ring, kTop, static_cast<int>(kWhole * std::clamp(*left_, 0.0, 1.0)));
    }
    painter.setPen(morale_ ? tokens.text : tokens.muted);
    painter.setFont(numberFont(kNumberSize, QFont::Bold));
    painter.drawText(place, Qt::AlignCenter, text());
}

void MoraleView::drawHistory(QPainter& painter, const QRectF& place) {
    const Tokens& tokens = tokensOf(palette());
    painter.setPen(QPen(tokens.grid, 1));
    painter.drawLine(place.bottomLeft(), place.bottomRight());
    float lowest = 0;
    float highest = 0;
    for (const float value : history_) {
        if (!std::isfinite(value)) continue;
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
    const double span = std::max(1.0F, highest - lowest);
    QPainterPath path;
    bool drawing = false;
    for (std::size_t i = 0; i < history_.size(); ++i) {
        if (!std::isfinite(history_[i])) {
            drawing = false;
            continue;
        }
        const double x =
            place.left() + place.width() * static_cast<double>(i + 1) / static_cast<double>(history_.size());
        const QPointF at(x, place.bottom() - place.height() * (history_[i] - lowest) / span);
        drawing ? path.lineTo(at) : path.moveTo(at);
        drawing = true;
    }
    painter.setPen(QPen(tokens.accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

}  // namespace kickstand::ui
