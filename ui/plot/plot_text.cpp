#include "ui/plot/plot_text.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPixmapCache>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr float kHaloOpacity = 0.6F;

void drawLetters(QPainter& painter, const QRect& rect, const QString& text, const QColor& ink) {
    painter.setPen(ink);
    painter.drawText(rect, Qt::AlignCenter, text);
}

/// The letters in the ground's colour, one pixel to every side, and then all that as thin as a veil.
void drawHalo(QPainter& painter, const QRect& rect, const QString& text, const QColor& ground) {
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx)
            drawLetters(painter, rect.translated(dx, dy), text, ground);
    }
    painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
    painter.fillRect(rect, QColor::fromRgbF(0, 0, 0, kHaloOpacity));
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

}  // namespace

PlotFonts plotFonts() {
    return {textFont(metrics::kSmallTextSize), textFont(metrics::kSmallTextSize, QFont::DemiBold),
            numberFont(metrics::kSmallTextSize, QFont::DemiBold)};
}

int textWidth(const QFont& font, const QString& text, int padding) {
    return QFontMetrics(font).horizontalAdvance(text) + 2 * padding;
}

void drawText(QPainter& painter, const QPointF& topLeft, const QString& text, const TextLook& look) {
    const double ratio = painter.device()->devicePixelRatioF();
    const QString key = QStringLiteral("plot-text/%1/%2/%3/%4/%5/%6/%7/%8")
                            .arg(text, painter.font().key(), look.ink.name(), look.ground.name())
                            .arg(look.padding)
                            .arg(look.height)
                            .arg(ratio)
                            .arg(static_cast<int>(look.kind));
    QPixmap picture;
    if (!QPixmapCache::find(key, &picture)) {
        const QSize size(textWidth(painter.font(), text, look.padding), look.height);
        picture = QPixmap(size * ratio);
        picture.setDevicePixelRatio(ratio);
        const QRect rect(QPoint(), size);
        const bool halo = look.kind == TextGround::Halo;
        picture.fill(halo ? QColor(Qt::transparent) : look.ground);
        QPainter inner(&picture);
        inner.setFont(painter.font());
        if (halo) drawHalo(inner, rect, text, look.ground);
        drawLetters(inner, rect, text, look.ink);
        inner.end();
        QPixmapCache::insert(key, picture);
    }
    painter.drawPixmap(topLeft, picture);
}

}  // namespace kickstand::ui
