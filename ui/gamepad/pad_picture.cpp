#include "ui/gamepad/pad_picture.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr double kDot = 4.5;
constexpr double kEdge = 7;
constexpr int kCurveSteps = 80;

}  // namespace

PadPicture::PadPicture(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setAccessibleName(tr("The sticks' curve, and where they stand"));
    setToolTip(tr("Across: where a stick stands. Up: what it comes to. The grey band is the dead zone."));
}

void PadPicture::show(const StickCurve& curve, const std::vector<double>& positions, bool counts) {
    if (curve == curve_ && positions == positions_ && counts == counts_) return;
    curve_ = curve;
    positions_ = positions;
    counts_ = counts;
    update();
}

QRectF PadPicture::area() const {
    const double side = std::min(width(), height()) - 2 * kEdge;
    return {(width() - side) / 2, (height() - side) / 2, side, side};
}

QPointF PadPicture::place(double position) const {
    const QRectF box = area();
    return {box.center().x() + position * box.width() / 2,
            box.center().y() - shaped(position, curve_) * box.height() / 2};
}

void PadPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    const QRectF box = area();
    const double dead = curve_.deadZone * box.width() / 2;
    painter.fillRect(QRectF(box.center().x() - dead, box.top(), 2 * dead, box.height()), t.grid);
    painter.setPen(QPen(t.line, 1));
    painter.drawRect(box);
    painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
    painter.drawLine(QPointF(box.center().x(), box.top()), QPointF(box.center().x(), box.bottom()));
    QPolygonF line;
    for (int step = -kCurveSteps; step <= kCurveSteps; ++step)
        line << place(static_cast<double>(step) / kCurveSteps);
    painter.setPen(QPen(t.muted, 1.5));
    painter.drawPolyline(line);
    const QColor ink = counts_ ? t.accent : t.muted;
    painter.setPen(QPen(ink, 2));
    painter.setBrush(counts_ ? QBrush(ink) : QBrush(t.surface));
    for (const double position : positions_)
        painter.drawEllipse(place(std::clamp(position, -1.0, 1.0)), kDot, kDot);
}

}  // namespace kickstand::ui
