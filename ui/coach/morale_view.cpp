#include "ui/coach/morale_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/coach/snapshot.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {
namespace {

constexpr double kRing = 6;
constexpr int kNumberSize = 32;
/// What the history's marks take.
constexpr double kMarkWidth = 28;
constexpr double kMarkHeight = 16;
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
    // From the mutiny up, so that one sees how far it is away.
    float lowest = coach::wire::kMutinyMorale;
    float highest = 0;
    for (const float value : history_) {
        if (!std::isfinite(value)) continue;
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
    const double span = std::max(1.0F, highest - lowest);
    const auto heightOf = [&](double value) {
        return place.bottom() - place.height() * (value - lowest) / span;
    };
    painter.setFont(textFont(metrics::kSmallTextSize));
    for (const int mark : {0, coach::wire::kMutinyMorale}) {
        const double y = heightOf(mark);
        painter.setPen(QPen(tokens.grid, 1));
        painter.drawLine(QPointF(place.left(), y), QPointF(place.right() - kMarkWidth, y));
        painter.setPen(tokens.muted);
        painter.drawText(QRectF(place.right() - kMarkWidth, y - kMarkHeight / 2, kMarkWidth, kMarkHeight),
                         Qt::AlignRight | Qt::AlignVCenter, signedNumber(mark));
    }
    QPainterPath path;
    bool drawing = false;
    for (std::size_t i = 0; i < history_.size(); ++i) {
        if (!std::isfinite(history_[i])) {
            drawing = false;
            continue;
        }
        const double x = place.left() + (place.width() - kMarkWidth) * static_cast<double>(i + 1) /
                                            static_cast<double>(history_.size());
        const QPointF at(x, heightOf(history_[i]));
        drawing ? path.lineTo(at) : path.moveTo(at);
        drawing = true;
    }
    painter.setPen(QPen(tokens.accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

}  // namespace kickstand::ui
