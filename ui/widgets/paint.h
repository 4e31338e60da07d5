#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

class QPainter;

namespace kickstand::ui {

/// Small drawings that several widgets share. The painter's state is left as it was.

/// A rounded label. `chipSize` says how much room it takes.
QSizeF chipSize(const QString& text, const QFont& font);
void drawChip(QPainter& painter, const QRectF& rect, const QString& text, const QFont& font,
              const QColor& fill, const QColor& ink);

/// How full something is, with notches on the way (0-1 each).
struct Level {
    double filled = 0;
    double lowMark = -1;
    double highMark = -1;
};
void drawLevel(QPainter& painter, const QRectF& rect, const Level& level, const QColor& fill,
               const QColor& track, const QColor& mark);

/// A lightning bolt that fills the rectangle: the same whatever fonts there are.
void drawBolt(QPainter& painter, const QRectF& rect, const QColor& colour);
void drawChevron(QPainter& painter, const QPointF& centre, const QColor& colour);

}  // namespace kickstand::ui
