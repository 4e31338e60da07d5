#include "ui/smartdevice/device_card.h"

#include <QPainter>

#include "ui/smartdevice/card_painter.h"
#include "ui/smartdevice/device_icon.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr double kPadding = 12;
constexpr double kHead = 24;
constexpr double kIcon = 18;
constexpr double kTone = 9;

}  // namespace

DeviceCard::DeviceCard(QWidget* parent) : QAbstractButton(parent) {
    setCheckable(true);
    setAutoExclusive(false);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    // It shows which board is chosen; a click asks for that.
    connect(this, &QAbstractButton::toggled, this, qOverload<>(&QWidget::update));
}

void DeviceCard::showCard(const QString& title, const QString& kind, const Standing& standing,
                          const CardContent& content, bool grey) {
    if (title == text() && kind == kind_ && standing == standing_ && content == content_ && grey == grey_)
        return;
    const bool wider = content.width != content_.width;
    setText(title);
    kind_ = kind;
    standing_ = standing;
    content_ = content;
    grey_ = grey;
    setAccessibleName(tr("%1, %2: %3").arg(title, standing.text, cardWords(content)));
    if (wider) updateGeometry();
    update();
}

void DeviceCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    const bool marked = isChecked() || hasFocus();
    painter.setPen(QPen(marked ? t.accent : underMouse() ? t.muted : t.line, isChecked() ? 2 : 1));
    painter.setBrush(t.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), metrics::kPanelRadius,
                            metrics::kPanelRadius);
    const QRectF inside = QRectF(rect()).adjusted(kPadding, 8, -kPadding, -8);
    drawDeviceIcon(painter, QRectF(inside.left(), inside.top() + 1, kIcon, kIcon), kind_.toStdString(),
                   grey_ ? t.muted : t.text);
    const QFont small = textFont(metrics::kSmallTextSize);
    const double width = QFontMetricsF(small).horizontalAdvance(standing_.text);
    QRectF head(inside.left() + kIcon + 8, inside.top(), inside.width() - kIcon - 8, kHead - 4);
    const QColor tone = toneColour(standing_.tone, t);
    painter.setFont(small);
    painter.setPen(tone);
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, standing_.text);
    drawTone(painter, standing_.tone,
             QRectF(head.right() - width - kTone - 5, head.center().y() - kTone / 2, kTone, kTone), tone);
    head.setRight(head.right() - width - kTone - 12);
    painter.setFont(textFont(metrics::kTextSize, QFont::DemiBold));
    painter.setPen(grey_ ? t.muted : t.text);
    painter.drawText(
        head, Qt::AlignLeft | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(text(), Qt::ElideRight, static_cast<int>(head.width())));
    drawCard(painter, inside.adjusted(0, kHead + 4, 0, 0), content_, t, grey_);
}

}  // namespace kickstand::ui
