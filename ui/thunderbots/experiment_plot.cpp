#include "ui/thunderbots/experiment_plot.h"

#include <QPainter>
#include <QPolygonF>

#include "ui/thunderbots/experiment_bytes.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr double kLeft = 30;
constexpr double kBottom = 18;
constexpr double kTop = 8;
constexpr double kRight = 10;
constexpr int kHighest = 255;
constexpr int kTick = 64;
constexpr std::size_t kBytes = thunderbots::wire::kExperimentBufferBytes;

}  // namespace

ExperimentPlot::ExperimentPlot(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("experimentPlot"));
    setBuffer({});
}

void ExperimentPlot::setBuffer(const thunderbots::ExperimentBuffer& buffer) {
    buffer_ = buffer;
    setAccessibleName(tr("Bytes over offset: %1").arg(experimentText(buffer_)));
    update();
}

QRectF ExperimentPlot::area() const {
    return QRectF(rect()).adjusted(kLeft, kTop, -kRight, -kBottom);
}

void ExperimentPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawGrid(painter);
    drawGaps(painter);
    drawBytes(painter);
}

void ExperimentPlot::drawGrid(QPainter& painter) const {
    const Tokens& t = tokensOf(palette());
    const QRectF plot = area();
    painter.setFont(numberFont(metrics::kSmallTextSize));
    for (int tick = 0; tick <= kHighest + 1; tick += kTick) {
        const double share = tick / static_cast<double>(kHighest + 1);
        const double x = std::round(plot.left() + share * plot.width()) + 0.5;
        const double y = std::round(plot.bottom() - share * plot.height()) + 0.5;
        painter.setPen(t.grid);
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(t.muted);
        const QString number = QString::number(tick);
        painter.drawText(QRectF(x - kLeft, plot.bottom() + 2, 2 * kLeft, kBottom - 2), Qt::AlignHCenter,
                         number);
        painter.drawText(QRectF(0, y - kBottom / 2, kLeft - 4, kBottom), Qt::AlignRight | Qt::AlignVCenter,
                         number);
    }
}

void ExperimentPlot::drawGaps(QPainter& painter) const {
    const Tokens& t = tokensOf(palette());
    const QRectF plot = area();
    const double step = plot.width() / static_cast<double>(kBytes);
    for (std::size_t first = 0; first < kBytes; ++first) {
        if (buffer_.known.test(first)) continue;
        std::size_t end = first;
        while (end < kBytes && !buffer_.known.test(end))
            ++end;
        const QRectF gap(plot.left() + step * static_cast<double>(first), plot.top(),
                         step * static_cast<double>(end - first), plot.height());
        painter.fillRect(gap, QBrush(t.line, Qt::BDiagPattern));
        first = end;
    }
}

void ExperimentPlot::drawBytes(QPainter& painter) const {
    const QRectF plot = area();
    const double step = plot.width() / static_cast<double>(kBytes);
    painter.setPen(tokensOf(palette()).accent);
    QPolygonF line;
    for (std::size_t offset = 0; offset <= kBytes; ++offset) {
        if (offset == kBytes || !buffer_.known.test(offset)) {
            painter.drawPolyline(line);
            line.clear();
            continue;
        }
        // A step for each byte: it holds from its own offset to the next.
        const double x = plot.left() + step * static_cast<double>(offset);
        const double y = plot.bottom() - plot.height() * buffer_.data[offset] / (kHighest + 1);
        line << QPointF(x, y) << QPointF(x + step, y);
    }
}

}  // namespace kickstand::ui
