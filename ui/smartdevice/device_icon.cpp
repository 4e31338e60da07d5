#include "ui/smartdevice/device_icon.h"

#include <QPainter>
#include <QPainterPath>
#include <array>

namespace kickstand::ui {

namespace {

/// Icons are drawn on a square of this many units.
constexpr double kUnits = 24;
constexpr double kPen = 1.8;

void motor(QPainter& p) {
    p.drawRoundedRect(QRectF(3, 6, 13, 12), 2, 2);
    p.drawLine(QPointF(16, 12), QPointF(21, 12));
    p.drawLine(QPointF(7, 10), QPointF(12, 10));
    p.drawLine(QPointF(7, 14), QPointF(12, 14));
}

void battery(QPainter& p) {
    p.drawRoundedRect(QRectF(3, 7, 16, 10), 2, 2);
    p.drawLine(QPointF(21.5, 10.5), QPointF(21.5, 13.5));
    for (const double x : {7.0, 11.0, 15.0})
        p.drawLine(QPointF(x, 10), QPointF(x, 14));
}

void limitSwitch(QPainter& p) {
    p.drawEllipse(QPointF(5, 16), 1.6, 1.6);
    p.drawEllipse(QPointF(19, 16), 1.6, 1.6);
    p.drawLine(QPointF(6.4, 15), QPointF(17, 7));
    p.drawLine(QPointF(12, 3), QPointF(12, 7));
}

void lineFollower(QPainter& p) {
    QPainterPath line(QPointF(7, 21));
    line.cubicTo(QPointF(7, 13), QPointF(17, 11), QPointF(17, 3));
    p.drawPath(line);
    for (const double x : {5.0, 12.0, 19.0})
        p.drawEllipse(QPointF(x, 12), 1.2, 1.2);
}

void dial(QPainter& p) {
    p.drawArc(QRectF(4, 5, 16, 16), -45 * 16, 270 * 16);
    p.drawLine(QPointF(12, 13), QPointF(16.5, 8.5));
}

void encoder(QPainter& p) {
    p.drawEllipse(QPointF(12, 12), 8.5, 8.5);
    p.drawEllipse(QPointF(12, 12), 2, 2);
    p.drawLine(QPointF(12, 3.5), QPointF(12, 7));
    p.drawLine(QPointF(20.5, 12), QPointF(17, 12));
    p.drawLine(QPointF(12, 20.5), QPointF(12, 17));
    p.drawLine(QPointF(3.5, 12), QPointF(7, 12));
}

void flag(QPainter& p) {
    p.drawLine(QPointF(6, 3), QPointF(6, 21));
    p.drawPolygon(QPolygonF{QPointF(6, 4), QPointF(19, 8), QPointF(6, 12)});
}

void servo(QPainter& p) {
    p.drawRoundedRect(QRectF(5, 11, 14, 10), 2, 2);
    p.drawLine(QPointF(9, 11), QPointF(9, 8));
    p.drawLine(QPointF(4, 5), QPointF(17, 8));
}

void tag(QPainter& p) {
    p.drawRoundedRect(QRectF(3, 6, 9, 12), 1.5, 1.5);
    for (const double radius : {4.0, 8.0})
        p.drawArc(QRectF(12 - radius, 12 - radius, 2 * radius, 2 * radius), -45 * 16, 90 * 16);
}

void chip(QPainter& p) {
    p.drawRoundedRect(QRectF(6, 6, 12, 12), 1.5, 1.5);
    for (const double at : {9.0, 12.0, 15.0}) {
        p.drawLine(QPointF(at, 3), QPointF(at, 6));
        p.drawLine(QPointF(at, 18), QPointF(at, 21));
    }
}

void plug(QPainter& p) {
    p.drawRoundedRect(QRectF(7, 9, 10, 7), 2, 2);
    p.drawLine(QPointF(10, 4), QPointF(10, 9));
    p.drawLine(QPointF(14, 4), QPointF(14, 9));
    p.drawLine(QPointF(12, 16), QPointF(12, 21));
}

struct Icon {
    std::string_view kind;
    void (*draw)(QPainter&);
};
constexpr std::array kIcons{Icon{"PolarBear", motor},
                            Icon{"YogiBear", motor},
                            Icon{"Grizzly", motor},
                            Icon{"BatteryBuzzer", battery},
                            Icon{"LimitSwitch", limitSwitch},
                            Icon{"LineFollower", lineFollower},
                            Icon{"Potentiometer", dial},
                            Icon{"Encoder", encoder},
                            Icon{"TeamFlag", flag},
                            Icon{"ServoControl", servo},
                            Icon{"RFID", tag}};

void drawOn(QPainter& painter, const QRectF& box, const QColor& ink, void (*draw)(QPainter&)) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(box.topLeft());
    painter.scale(box.width() / kUnits, box.height() / kUnits);
    painter.setPen(QPen(ink, kPen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    draw(painter);
    painter.restore();
}

}  // namespace

void drawDeviceIcon(QPainter& painter, const QRectF& box, std::string_view kind, const QColor& ink) {
    for (const Icon& icon : kIcons) {
        if (icon.kind == kind) return drawOn(painter, box, ink, icon.draw);
    }
    drawOn(painter, box, ink, chip);
}

void drawPortIcon(QPainter& painter, const QRectF& box, const QColor& ink) {
    drawOn(painter, box, ink, plug);
}

}  // namespace kickstand::ui
