#include "ui/widgets/paint.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace kickstand::ui {

namespace {

constexpr double kChipPadding = 5;
constexpr double kChipRadius = 4;

/// Saves the painter and smooths its edges while it lives.
class Smooth {
  public:
    explicit Smooth(QPainter& painter) : painter_(painter) {
        painter_.save();
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setPen(Qt::NoPen);
    }
    ~Smooth() { painter_.restore(); }
    Smooth(const Smooth&) = delete;
    Smooth& operator=(const Smooth&) = delete;

  private:
    QPainter& painter_;
};

}  // namespace

QSizeF chipSize(const QString& text, const QFont& font) {
    const QFontMetricsF metrics(font);
    return {metrics.horizontalAdvance(text) + 2 * kChipPadding, metrics.height() + 2};
}

void drawChip(QPainter& painter, const QRectF& rect, const QString& text, const QFont& font,
              const QColor& fill, const QColor& ink) {
    const Smooth smooth(painter);
    painter.setBrush(fill);
    painter.drawRoundedRect(rect, kChipRadius, kChipRadius);
    painter.setPen(ink);
    painter.setFont(font);
    painter.drawText(rect.adjusted(kChipPadding, 0, -kChipPadding, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     text);
}

void drawLevel(QPainter& painter, const QRectF& rect, const Level& level, const QColor& fill,
               const QColor& track, const QColor& mark) {
    const Smooth smooth(painter);
    const double radius = rect.height() / 2;
    painter.setBrush(track);
    painter.drawRoundedRect(rect, radius, radius);
    const double filled = std::clamp(level.filled, 0.0, 1.0);
    if (filled > 0) {
        painter.setBrush(fill);
        painter.drawRoundedRect(
            QRectF(rect.topLeft(), QSizeF(std::max(rect.width() * filled, rect.height()), rect.height())),
            radius, radius);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const double at : {level.lowMark, level.highMark}) {
        if (at <= 0 || at >= 1) continue;
        painter.fillRect(QRectF(std::round(rect.left() + rect.width() * at), rect.top(), 1, rect.height()),
                         mark);
    }
}

void drawBolt(QPainter& painter, const QRectF& rect, const QColor& colour) {
    const Smooth smooth(painter);
    painter.setBrush(colour);
    const auto at = [&rect](double x, double y) {
        return QPointF(rect.left() + rect.width() * x, rect.top() + rect.height() * y);
    };
    painter.drawPolygon(
        QPolygonF{at(0.66, 0), at(0.06, 0.58), at(0.46, 0.58), at(0.32, 1), at(0.94, 0.4), at(0.54, 0.4)});
}

void drawChevron(QPainter& painter, const QPointF& centre, const QColor& colour) {
    const Smooth smooth(painter);
    painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(
        QPolygonF{centre + QPointF(-3.5, -1.5), centre + QPointF(0, 2), centre + QPointF(3.5, -1.5)});
}

}  // namespace kickstand::ui
