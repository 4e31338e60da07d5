#include "ui/coach/helm_pad.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "core/engine/describe_coach.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using coach::wire::kLevelPercent;
using coach::wire::Velocity;

namespace {

constexpr double kThumb = 8;
constexpr double kRing = 12;
/// What an arrow key asks for, and with Shift.
constexpr int kKeyLevel = 7;
constexpr int kFineLevel = 3;

}  // namespace

HelmPad::HelmPad(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Helm"));
    setToolTip(
        tr("Pull, or hold the arrow keys (with Shift gently); let go to stop. Left is counterclockwise"));
}

QRectF HelmPad::field() const {
    const double side = std::min(width(), height()) - 2 * kRing;
    return {(width() - side) / 2, (height() - side) / 2, side, side};
}

QPointF HelmPad::placeOf(const Velocity& velocity) const {
    const QRectF place = field();
    // Left is counterclockwise, as a boat turns.
    const double x = -coach::wire::percentOf(velocity.turn) / 100.0;
    const double y = -coach::wire::percentOf(velocity.forward) / 100.0;
    return place.center() + QPointF(x * place.width() / 2, y * place.height() / 2);
}

void HelmPad::setTold(const std::optional<Velocity>& velocity, bool answered) {
    if (told_ == velocity && answered_ == answered) return;
    told_ = velocity;
    answered_ = answered;
    update();
}

void HelmPad::ask(const Velocity& velocity) {
    if (velocity == asked_) return;
    // It was at rest until now, which the session wants to hear before anything that is held.
    if (asked_.isZero()) emit steered(0, 0);
    asked_ = velocity;
    setAccessibleDescription(describe(velocity));
    update();
    emit steered(velocity.forward, velocity.turn);
}

void HelmPad::letGo() {
    pulled_ = false;
    keys_.clear();
    ask({});
}

bool HelmPad::hold(const Velocity& velocity) {
    if (isPulled() || !isEnabled() || !isVisible()) return false;
    ask(velocity);
    return true;
}

void HelmPad::pull(const QPointF& at) {
    const QRectF place = field();
    const QPointF from = at - place.center();
    ask({coach::wire::nearestLevel(-200 * from.y() / place.height()),
         coach::wire::nearestLevel(-200 * from.x() / place.width())});
}

void HelmPad::followKeys(bool fine) {
    const int level = fine ? kFineLevel : kKeyLevel;
    const auto axis = [this, level](int more, int less) {
        return (keys_.contains(more) ? level : 0) - (keys_.contains(less) ? level : 0);
    };
    ask({axis(Qt::Key_Up, Qt::Key_Down), axis(Qt::Key_Left, Qt::Key_Right)});
}

void HelmPad::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    pulled_ = true;
    pull(event->position());
}

void HelmPad::mouseMoveEvent(QMouseEvent* event) {
    if (pulled_) pull(event->position());
}

void HelmPad::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) letGo();
}

void HelmPad::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key != Qt::Key_Up && key != Qt::Key_Down && key != Qt::Key_Left && key != Qt::Key_Right)
        return QWidget::keyPressEvent(event);
    if (event->isAutoRepeat()) return;
    keys_.insert(key);
    followKeys(event->modifiers().testFlag(Qt::ShiftModifier));
}

void HelmPad::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat()) return;
    if (keys_.erase(event->key()) == 0) return QWidget::keyReleaseEvent(event);
    followKeys(event->modifiers().testFlag(Qt::ShiftModifier));
}

void HelmPad::focusOutEvent(QFocusEvent* event) {
    if (isPulled()) letGo();
    QWidget::focusOutEvent(event);
}

void HelmPad::hideEvent(QHideEvent* event) {
    letGo();
    QWidget::hideEvent(event);
}

void HelmPad::paintEvent(QPaintEvent*) {
    const Tokens& tokens = tokensOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF place = field();
    painter.setPen(QPen(hasFocus() ? tokens.accent : tokens.line, 1));
    painter.setBrush(tokens.surface);
    painter.drawRoundedRect(place.adjusted(-kRing, -kRing, kRing, kRing), metrics::kPanelRadius,
                            metrics::kPanelRadius);
    drawLevels(painter, place);
    if (told_) {
        painter.setPen(QPen(answered_ ? tokens.ok : tokens.warn, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(placeOf(*told_), kRing, kRing);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(isEnabled() ? tokens.accent : tokens.muted);
    painter.drawEllipse(placeOf(asked_), kThumb, kThumb);
}

/// A line for each level there is, the middle ones stronger.
void HelmPad::drawLevels(QPainter& painter, const QRectF& place) const {
    const Tokens& tokens = tokensOf(palette());
    for (const int percent : kLevelPercent) {
        painter.setPen(QPen(percent == 0 ? tokens.line : tokens.grid, 1));
        const double x = percent / 200.0 * place.width();
        const double y = percent / 200.0 * place.height();
        for (const int sign : {-1, 1}) {
            painter.drawLine(QPointF(place.center().x() + sign * x, place.top()),
                             QPointF(place.center().x() + sign * x, place.bottom()));
            painter.drawLine(QPointF(place.left(), place.center().y() + sign * y),
                             QPointF(place.right(), place.center().y() + sign * y));
        }
    }
}

}  // namespace kickstand::ui
