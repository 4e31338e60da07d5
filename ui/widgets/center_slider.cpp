#include "ui/widgets/center_slider.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr double kThumbRadius = 8;
constexpr double kTrack = 4;

}  // namespace

CenterSlider::CenterSlider(QWidget* parent) : QAbstractSlider(parent) {
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void CenterSlider::setReached(int value) {
    if (value == reached_) return;
    reached_ = value;
    update();
}

void CenterSlider::letGo() {
    if (isSliderDown()) setSliderDown(false);
}

double CenterSlider::positionOf(int value) const {
    const double span = width() - 2 * kThumbRadius;
    const int range = maximum() - minimum();
    if (range <= 0) return width() / 2.0;
    return kThumbRadius + span * (std::clamp(value, minimum(), maximum()) - minimum()) / range;
}

void CenterSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const Tokens& t = tokensOf(palette());
    const double middle = height() / 2.0;
    const auto bar = [&](double from, double to, const QColor& colour) {
        if (from == to) return;
        painter.setBrush(colour);
        painter.drawRoundedRect(QRectF(QPointF(std::min(from, to), middle - kTrack / 2),
                                       QPointF(std::max(from, to), middle + kTrack / 2)),
                                kTrack / 2, kTrack / 2);
    };
    const QColor ink = isEnabled() ? t.accent : t.muted;
    bar(kThumbRadius, width() - kThumbRadius, t.line);
    // What was asked for is drawn faintly, what has been reached of it in full.
    QColor faint = ink;
    faint.setAlphaF(0.4F);
    bar(positionOf(0), positionOf(value()), faint);
    bar(positionOf(0), positionOf(reached_), ink);
    painter.fillRect(QRectF(positionOf(0) - 0.5, middle - 5, 1, 10), t.muted);

    const QPointF thumb(positionOf(sliderPosition()), middle);
    if (hasFocus() && window()->testAttribute(Qt::WA_KeyboardFocusChange)) {
        painter.setBrush(t.accentSoft);
        painter.drawEllipse(thumb, kThumbRadius + 3, kThumbRadius + 3);
    }
    painter.setBrush(isSliderDown() ? ink : t.surface);
    painter.setPen(QPen(isEnabled() ? t.accent : t.line, 2));
    painter.drawEllipse(thumb, kThumbRadius - 1, kThumbRadius - 1);
}

void CenterSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    pressedAt_ = event->position().x();
    valueAtPress_ = value();
    setSliderDown(true);
    update();
}

void CenterSlider::mouseMoveEvent(QMouseEvent* event) {
    if (!isSliderDown()) return;
    const double span = width() - 2 * kThumbRadius;
    const double moved = (event->position().x() - pressedAt_) * (maximum() - minimum()) / std::max(1.0, span);
    setSliderPosition(valueAtPress_ + static_cast<int>(std::lround(moved)));
}

void CenterSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) letGo();
    update();
}

void CenterSlider::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) emit zeroAsked();
}

void CenterSlider::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

void CenterSlider::keyPressEvent(QKeyEvent* event) {
    if (event->isAutoRepeat() && !isSliderDown()) setSliderDown(true);
    QAbstractSlider::keyPressEvent(event);
}

void CenterSlider::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat()) letGo();
    QAbstractSlider::keyReleaseEvent(event);
}

void CenterSlider::hideEvent(QHideEvent* event) {
    letGo();
    QAbstractSlider::hideEvent(event);
}

void CenterSlider::focusOutEvent(QFocusEvent* event) {
    letGo();
    QAbstractSlider::focusOutEvent(event);
}

void CenterSlider::changeEvent(QEvent* event) {
    if (event->type() == QEvent::EnabledChange && !isEnabled()) letGo();
    QAbstractSlider::changeEvent(event);
}

}  // namespace kickstand::ui
