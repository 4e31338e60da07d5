#include "ui/plot/mark_looks.h"

#include <QPainter>
#include <QPixmapCache>
#include <QPolygonF>
#include <array>
#include <numeric>

#include "ui/plot/mark_lane.h"

namespace kickstand::ui {

namespace {

/// A shape on a square of kLaneGlyph pixels.
enum class Shape { Down, Cross, Square, Plus, Minus, Diamond, Right };

struct Look {
    Shape shape;
    bool filled;
    std::array<int, 4> dashes;  ///< Drawn, left out, drawn, left out; in pixels.
};

/// Of two shapes the filled one is what a person does or what begins.
Look lookAt(int look) {
    if (look == kTriggerLook) return {Shape::Right, true, {9, 3, 2, 3}};
    switch (static_cast<MarkKind>(look)) {
        case MarkKind::Kick:
            return {Shape::Down, true, {6, 3, 6, 3}};
        case MarkKind::Autokick:
            return {Shape::Down, false, {6, 3, 1, 3}};
        case MarkKind::DeviceError:
            return {Shape::Cross, false, {3, 3, 3, 3}};
        case MarkKind::Stop:
            return {Shape::Square, true, {1, 0, 1, 0}};
        case MarkKind::Rearmed:
            return {Shape::Square, false, {12, 4, 12, 4}};
        case MarkKind::LinkUp:
            return {Shape::Plus, true, {1, 2, 1, 2}};
        case MarkKind::LinkDown:
            return {Shape::Minus, true, {2, 2, 2, 6}};
        case MarkKind::UnitHeard:
            return {Shape::Diamond, true, {1, 4, 1, 4}};
        case MarkKind::UnitLost:
            return {Shape::Diamond, false, {1, 2, 1, 6}};
    }
    return {Shape::Minus, true, {1, 2, 1, 2}};
}

void drawShape(QPainter& painter, Shape shape) {
    constexpr double kSide = kLaneGlyph;
    constexpr double kMiddle = kSide / 2;
    const QRectF box(0.5, 0.5, kSide - 1, kSide - 1);
    switch (shape) {
        case Shape::Down:
            painter.drawPolygon(QPolygonF({box.topLeft(), box.topRight(), QPointF(kMiddle, box.bottom())}));
            return;
        case Shape::Right:
            painter.drawPolygon(QPolygonF({box.topLeft(), QPointF(box.right(), kMiddle), box.bottomLeft()}));
            return;
        case Shape::Cross:
            painter.drawLine(box.topLeft(), box.bottomRight());
            painter.drawLine(box.bottomLeft(), box.topRight());
            return;
        case Shape::Square:
            painter.drawRect(box);
            return;
        case Shape::Plus:
            painter.drawRect(QRectF(kMiddle - 1, 0.5, 2, kSide - 1));
            [[fallthrough]];
        case Shape::Minus:
            painter.drawRect(QRectF(0.5, kMiddle - 1, kSide - 1, 2));
            return;
        case Shape::Diamond:
            painter.drawPolygon(QPolygonF({QPointF(kMiddle, 0), QPointF(kSide, kMiddle),
                                           QPointF(kMiddle, kSide), QPointF(0, kMiddle)}));
            return;
    }
}

QPixmap emptyPixmap(int width, int height, double pixelRatio) {
    QPixmap picture(QSize(width, height) * pixelRatio);
    picture.setDevicePixelRatio(pixelRatio);
    picture.fill(Qt::transparent);
    return picture;
}

}  // namespace

QPixmap markGlyph(int look, const QColor& ink, double pixelRatio) {
    const QString key = QStringLiteral("mark-glyph/%1/%2/%3").arg(look).arg(ink.name()).arg(pixelRatio);
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) return picture;
    picture = emptyPixmap(kLaneGlyph, kLaneGlyph, pixelRatio);
    const Look drawn = lookAt(look);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 1));
    if (drawn.filled) painter.setBrush(ink);
    drawShape(painter, drawn.shape);
    painter.end();
    QPixmapCache::insert(key, picture);
    return picture;
}

QPixmap markLine(int look, const QColor& ink, int height, double pixelRatio) {
    const QString key =
        QStringLiteral("mark-line/%1/%2/%3/%4").arg(look).arg(ink.name()).arg(height).arg(pixelRatio);
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) return picture;
    picture = emptyPixmap(1, height, pixelRatio);
    const Look drawn = lookAt(look);
    QPainter painter(&picture);
    int y = 0;
    for (std::size_t i = 0; y < height; i = (i + 1) % drawn.dashes.size()) {
        if (i % 2 == 0) painter.fillRect(0, y, 1, drawn.dashes[i], ink);
        y += drawn.dashes[i];
    }
    painter.end();
    QPixmapCache::insert(key, picture);
    return picture;
}

}  // namespace kickstand::ui
