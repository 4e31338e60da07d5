#include "ui/widgets/state_label.h"

#include <QFontMetrics>
#include <QPainter>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kShape = 10;
constexpr int kShapeGap = 6;

QFont strongFont(const QFont& font) {
    QFont bold = font;
    bold.setWeight(QFont::DemiBold);
    return bold;
}

}  // namespace

QColor toneColour(Tone tone, const Tokens& tokens) {
    switch (tone) {
        case Tone::Idle:
            return tokens.muted;
        case Tone::Busy:
            return tokens.accent;
        case Tone::Good:
            return tokens.ok;
        case Tone::Warning:
            return tokens.warn;
        case Tone::Danger:
            return tokens.danger;
    }
    return tokens.muted;
}

void drawTone(QPainter& painter, Tone tone, const QRectF& box, const QColor& colour) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    const QRectF ring = box.adjusted(1, 1, -1, -1);
    switch (tone) {
        case Tone::Idle:
            painter.drawEllipse(ring);
            return;
        case Tone::Busy:
            painter.drawEllipse(ring);
            painter.setBrush(colour);
            painter.drawPie(ring, 90 * 16, 180 * 16);
            return;
        case Tone::Good:
            painter.setBrush(colour);
            painter.drawEllipse(ring);
            return;
        case Tone::Warning:
            painter.setBrush(colour);
            painter.drawPolygon(
                QPolygonF{{ring.center().x(), ring.top()}, ring.bottomRight(), ring.bottomLeft()});
            return;
        case Tone::Danger:
            painter.setBrush(colour);
            painter.drawRect(ring);
            return;
    }
}

StateLabel::StateLabel(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void StateLabel::setState(Tone tone, const QString& text, const QString& strong) {
    if (tone == tone_ && text == text_ && strong == strong_) return;
    tone_ = tone;
    text_ = text;
    strong_ = strong;
    setAccessibleName(this->text());
    setToolTip(this->text());
    updateGeometry();
    update();
}

QString StateLabel::text() const {
    return strong_.isEmpty() ? text_ : text_ + u' ' + strong_;
}

QSize StateLabel::sizeHint() const {
    int width = kShape + kShapeGap + fontMetrics().horizontalAdvance(text_);
    if (!strong_.isEmpty()) width += QFontMetrics(strongFont(font())).horizontalAdvance(u' ' + strong_);
    return {width + 2, fontMetrics().height() + 2};
}

QSize StateLabel::minimumSizeHint() const {
    return {qMin(120, sizeHint().width()), sizeHint().height()};
}

void StateLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Tokens& t = tokensOf(palette());
    drawTone(painter, tone_, QRectF(0, (height() - kShape) / 2.0, kShape, kShape), toneColour(tone_, t));
    const int from = kShape + kShapeGap;
    const QString shown = fontMetrics().elidedText(text_, Qt::ElideRight, width() - from);
    painter.setPen(t.text);
    painter.drawText(QRect(from, 0, width() - from, height()), Qt::AlignVCenter, shown);
    if (strong_.isEmpty() || shown != text_) return;
    painter.setFont(strongFont(font()));
    const int left = from + fontMetrics().horizontalAdvance(text_ + u' ');
    painter.drawText(QRect(left, 0, width() - left, height()), Qt::AlignVCenter, strong_);
}

}  // namespace kickstand::ui
