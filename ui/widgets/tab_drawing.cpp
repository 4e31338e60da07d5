#include "ui/widgets/tab_drawing.h"

#include <QPainter>
#include <QStyleOptionTab>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kTabHeight = 30;
constexpr int kTabPadding = 10;
constexpr int kUnderline = 2;

QFont fontOf(bool chosen) {
    return textFont(metrics::kTextSize, chosen ? QFont::DemiBold : QFont::Normal);
}

}  // namespace

QSize tabSize(const QStyleOptionTab& tab) {
    // As wide as it is when it is chosen: choosing moves nothing.
    const int words = QFontMetrics(fontOf(true)).size(Qt::TextShowMnemonic, tab.text).width();
    return {words + 2 * kTabPadding, kTabHeight};
}

void drawTab(const QStyleOptionTab& tab, QPainter& painter) {
    const Tokens& t = tokensOf(tab.palette);
    const bool chosen = tab.state.testFlag(QStyle::State_Selected);
    const bool under = tab.state.testFlag(QStyle::State_MouseOver) && !chosen;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (under) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(t.accentSoft);
        painter.drawRoundedRect(QRectF(tab.rect).adjusted(2, 3, -2, -4), metrics::kControlRadius,
                                metrics::kControlRadius);
    }
    if (tab.state.testFlag(QStyle::State_HasFocus)) {
        painter.setPen(QPen(t.accent, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(tab.rect).adjusted(3, 3, -3, -4), 4, 4);
    }
    if (chosen) {
        const QRect line(tab.rect.left() + kTabPadding, tab.rect.bottom() - kUnderline,
                         tab.rect.width() - 2 * kTabPadding, kUnderline);
        painter.fillRect(line, t.accent);
    }
    painter.setFont(fontOf(chosen));
    painter.setPen(chosen ? t.text : t.muted);
    painter.drawText(tab.rect.adjusted(0, 0, 0, -kUnderline), Qt::AlignCenter | Qt::TextShowMnemonic,
                     tab.text);
    painter.restore();
}

}  // namespace kickstand::ui
