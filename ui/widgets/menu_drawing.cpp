#include "ui/widgets/menu_drawing.h"

#include <QPainter>
#include <QStyleOption>

#include "ui/widgets/paint.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kItemHeight = 28;
constexpr int kHeadingHeight = 26;
constexpr int kLineHeight = 9;
constexpr int kTextLeft = 30;
constexpr int kRight = 24;
constexpr int kShortcutGap = 28;

bool isLine(const QStyleOptionMenuItem& item) {
    return item.menuItemType == QStyleOptionMenuItem::Separator && item.text.isEmpty();
}

bool isHeading(const QStyleOptionMenuItem& item) {
    return item.menuItemType == QStyleOptionMenuItem::Separator && !item.text.isEmpty();
}

QFont headingFont() {
    return textFont(metrics::kSmallTextSize, QFont::DemiBold);
}

QString wordsOf(const QStyleOptionMenuItem& item) {
    return item.text.section(u'\t', 0, 0);
}

QString shortcutOf(const QStyleOptionMenuItem& item) {
    return item.text.section(u'\t', 1);
}

void drawMark(const QStyleOptionMenuItem& item, QPainter& painter, const QColor& ink) {
    if (item.checkType == QStyleOptionMenuItem::NotCheckable || !item.checked) return;
    const QPointF centre(item.rect.left() + kTextLeft / 2.0, item.rect.center().y() + 0.5);
    if (item.checkType == QStyleOptionMenuItem::Exclusive) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawEllipse(centre, 3, 3);
        return;
    }
    painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(
        QPolygonF{centre + QPointF(-4, 0), centre + QPointF(-1.2, 3), centre + QPointF(4.2, -3.4)});
}

}  // namespace

void drawMenuPanel(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokensOf(option.palette);
    painter.save();
    painter.setPen(QPen(t.line, 1));
    painter.setBrush(t.surface);
    painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
    painter.restore();
}

void drawMenuItem(const QStyleOptionMenuItem& item, QPainter& painter) {
    const Tokens& t = tokensOf(item.palette);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (isLine(item)) {
        painter.fillRect(QRect(item.rect.left(), item.rect.center().y(), item.rect.width(), 1), t.grid);
        painter.restore();
        return;
    }
    if (isHeading(item)) {
        painter.setFont(headingFont());
        painter.setPen(t.muted);
        painter.drawText(item.rect.adjusted(metrics::kGap, 4, 0, 0), Qt::AlignVCenter, item.text);
        painter.restore();
        return;
    }
    const bool enabled = item.state.testFlag(QStyle::State_Enabled);
    if (enabled && item.state.testFlag(QStyle::State_Selected)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(t.accentSoft);
        painter.drawRoundedRect(item.rect, 4, 4);
    }
    const QColor ink = item.palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::Text);
    drawMark(item, painter, enabled ? t.accent : ink);
    painter.setFont(item.font);
    painter.setPen(ink);
    const QRect text = item.rect.adjusted(kTextLeft, 0, -kRight / 2, 0);
    painter.drawText(text, Qt::AlignVCenter | Qt::TextShowMnemonic | Qt::TextSingleLine, wordsOf(item));
    painter.setPen(t.muted);
    painter.drawText(text, Qt::AlignVCenter | Qt::AlignRight, shortcutOf(item));
    if (item.menuItemType == QStyleOptionMenuItem::SubMenu) {
        painter.translate(item.rect.right() - 10, item.rect.center().y() + 0.5);
        painter.rotate(-90);
        drawChevron(painter, {}, ink);
    }
    painter.restore();
}

QSize menuItemSize(const QStyleOptionMenuItem& item) {
    if (isLine(item)) return {10, kLineHeight};
    if (isHeading(item))
        return {QFontMetrics(headingFont()).horizontalAdvance(item.text) + kRight, kHeadingHeight};
    const QFontMetrics metrics(item.font);
    int width =
        kTextLeft + metrics.size(Qt::TextShowMnemonic | Qt::TextSingleLine, wordsOf(item)).width() + kRight;
    const QString shortcut = shortcutOf(item);
    if (!shortcut.isEmpty()) width += kShortcutGap + metrics.horizontalAdvance(shortcut);
    return {width, kItemHeight};
}

}  // namespace kickstand::ui
