#pragma once

#include <QRectF>
#include <string_view>

class QColor;
class QPainter;

namespace kickstand::ui {

/// Draws what a kind of board stands for, in lines: a motor, a battery, a switch, …; a plug for what has no
/// board, and a chip for a kind that has no picture. The painter's state is left as it was.
void drawDeviceIcon(QPainter& painter, const QRectF& box, std::string_view kind, const QColor& ink);
void drawPortIcon(QPainter& painter, const QRectF& box, const QColor& ink);

}  // namespace kickstand::ui
