#include "ui/plot/plot_text.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPixmapCache>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

PlotFonts plotFonts() {
    return {textFont(metrics::kSmallTextSize), textFont(metrics::kSmallTextSize, QFont::DemiBold),
            numberFont(metrics::kSmallTextSize, QFont::DemiBold)};
}

int textWidth(const QFont& font, const QString& text, int padding) {
    return QFontMetrics(font).horizontalAdvance(text) + 2 * padding;
}

void drawText(QPainter& painter, const QPointF& topLeft, const QString& text, const TextLook& look) {
    const double ratio = painter.device()->devicePixelRatioF();
    const QString key = QStringLiteral("plot-text/%1/%2/%3/%4/%5/%6/%7")
                            .arg(text, painter.font().key(), look.ink.name(), look.ground.name())
                            .arg(look.padding)
                            .arg(look.height)
                            .arg(ratio);
    QPixmap picture;
    if (!QPixmapCache::find(key, &picture)) {
        const QSize size(textWidth(painter.font(), text, look.padding), look.height);
        picture = QPixmap(size * ratio);
        picture.setDevicePixelRatio(ratio);
        picture.fill(look.ground);
        QPainter inner(&picture);
        inner.setFont(painter.font());
        inner.setPen(look.ink);
        inner.drawText(QRect(QPoint(), size), Qt::AlignCenter, text);
        inner.end();
        QPixmapCache::insert(key, picture);
    }
    painter.drawPixmap(topLeft, picture);
}

}  // namespace kickstand::ui
