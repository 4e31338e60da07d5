#pragma once

#include <QImage>
#include <span>
#include <vector>

#include "core/telemetry/sample.h"
#include "ui/plot/value_range.h"

class QPainter;

namespace kickstand::ui {

/// The columns of one curve that are to be drawn, and how.
struct DrawnSpan {
    QRgb colour = 0;
    std::span<const Column> columns;
};

/// A picture of curves as vertical spans from the least to the greatest value of each column of pixels. Its
/// columns are places of a ring; nothing is drawn twice, and showing it is copying it.
class SpanImage {
  public:
    /// Empty, with room for so many columns, each `stroke` device pixels wide: lines are as thick. `rows` are
    /// device pixels too, of which there are `pixelRatio` to one that does not depend on the device.
    void resize(int places, int rows, int stroke, double pixelRatio);
    int rows() const { return image_.height(); }

    /// Draws all curves anew into neighbouring places from `place` on; later ones over earlier ones. All have
    /// as many columns.
    void draw(int place, std::span<const DrawnSpan> curves, const ValueRows& rows);
    /// Copies `count` places to (x, y), which are device-independent pixels.
    void show(QPainter& painter, double x, double y, int place, int count) const;
    /// The colour at a place, for whoever checks it.
    QRgb pixel(int place, int row) const { return image_.pixel(place * stroke_, row); }

  private:
    void fill(int column, const Column& span, QRgb colour, const ValueRows& rows);
    void copyOut(int place, int count);

    QImage image_;
    int stroke_ = 1;
    /// Some columns side by side, each contiguous: filling them and turning them over into rows is several
    /// times as fast as filling the picture's columns one pixel a row.
    std::vector<QRgb> tile_;
};

}  // namespace kickstand::ui
