#include "ui/plot/span_image.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace kickstand::ui {

namespace {

/// A cache line of the picture.
constexpr int kTileColumns = 16;

}  // namespace

void SpanImage::resize(int places, int rows, int stroke, double pixelRatio) {
    stroke_ = stroke;
    image_ = QImage(places * stroke, rows, QImage::Format_ARGB32_Premultiplied);
    // The picture is in device pixels already; saying so keeps painters from scaling it.
    image_.setDevicePixelRatio(pixelRatio);
    image_.fill(Qt::transparent);
    tile_.assign(static_cast<std::size_t>(kTileColumns) * static_cast<std::size_t>(rows), 0);
}

void SpanImage::draw(int place, std::span<const DrawnSpan> curves, const ValueRows& rows) {
    if (curves.empty() || image_.isNull()) return;
    const auto count = static_cast<int>(curves.front().columns.size());
    for (int first = 0; first < count; first += kTileColumns) {
        const int width = std::min(kTileColumns, count - first);
        std::fill(tile_.begin(), tile_.end(), 0);
        for (const DrawnSpan& curve : curves) {
            for (int i = 0; i < width; ++i)
                fill(i, curve.columns[static_cast<std::size_t>(first + i)], curve.colour, rows);
        }
        copyOut(place + first, width);
    }
}

void SpanImage::fill(int column, const Column& span, QRgb colour, const ValueRows& rows) {
    if (std::isnan(span.min)) return;
    const int top = std::max(rows.rowOf(span.max), 0);
    const int bottom = std::min(rows.rowOf(span.min) + stroke_, this->rows());
    if (top >= bottom) return;
    QRgb* line = tile_.data() + static_cast<std::ptrdiff_t>(column) * this->rows();
    std::fill(line + top, line + bottom, colour);
}

void SpanImage::copyOut(int place, int count) {
    const int rows = this->rows();
    uchar* line = image_.bits();
    for (int row = 0; row < rows; ++row, line += image_.bytesPerLine()) {
        auto* out = reinterpret_cast<QRgb*>(line) + place * stroke_;
        const QRgb* in = tile_.data() + row;
        for (int i = 0; i < count; ++i, in += rows)
            out = std::fill_n(out, stroke_, *in);
    }
}

void SpanImage::show(QPainter& painter, double x, double y, int place, int count) const {
    if (count <= 0) return;
    painter.drawImage(QPointF(x, y), image_, QRectF(place * stroke_, 0, count * stroke_, image_.height()));
}

}  // namespace kickstand::ui
