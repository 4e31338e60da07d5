#include "ui/thunderbots/kick_pulses_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kHeight = 112;
constexpr int kLeastWidth = 280;
constexpr int kLeftMargin = 28;
constexpr int kRightMargin = 20;
constexpr int kScaleHeight = 20;
constexpr double kPulseHeight = 28;
constexpr double kFirstBase = 42;
constexpr double kSecondBase = 86;
constexpr double kKnob = 5;
constexpr int kPageSteps = 10;

/// The Okabe-Ito pair that the plots begin with: told apart by everybody.
QColor colourOf(int solenoid, bool dark) {
    if (solenoid == 1) return dark ? QColor(0x56, 0xB4, 0xE9) : QColor(0x00, 0x72, 0xB2);
    return dark ? QColor(0xE6, 0x9F, 0x00) : QColor(0xD5, 0x5E, 0x00);
}

const char* nameOf(PulseEdge edge) {
    switch (edge) {
        case PulseEdge::Start1:
            return "edgeStart1";
        case PulseEdge::End1:
            return "edgeEnd1";
        case PulseEdge::Start2:
            return "edgeStart2";
        case PulseEdge::End2:
            return "edgeEnd2";
    }
    return "";
}

}  // namespace

KickPulsesView::KickPulsesView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("kickPulses"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Pulses of both solenoids"));
    labels_ = {tr("solenoid 1"), tr("solenoid 2")};
    for (const PulseEdge edge : kPulseEdges)
        handles_[static_cast<std::size_t>(edge)] = new PulseHandle(edge, this);
    showPulses({});
}

void KickPulsesView::setLabels(const QString& first, const QString& second) {
    const std::array<QString, 2> labels{tr("%1 \u00b7 solenoid 1").arg(first),
                                        tr("%1 \u00b7 solenoid 2").arg(second)};
    if (labels == labels_) return;
    labels_ = labels;
    placeHandles();
    update();
}

QSize KickPulsesView::sizeHint() const {
    return {kLeastWidth, kHeight};
}

QSize KickPulsesView::minimumSizeHint() const {
    return sizeHint();
}

PulseAxis KickPulsesView::axis() const {
    return {static_cast<double>(kLeftMargin), static_cast<double>(width() - kRightMargin), wire::kKickMax_us};
}

double KickPulsesView::baseOf(int solenoid) const {
    return solenoid == 1 ? kFirstBase : kSecondBase;
}

void KickPulsesView::showPulses(const wire::KickPulses& pulses) {
    pulses_ = pulses;
    placeHandles();
    update();
}

void KickPulsesView::placeHandles() {
    const PulseAxis along = axis();
    for (const PulseEdge edge : kPulseEdges) {
        PulseHandle* handle = handles_[static_cast<std::size_t>(edge)];
        const int solenoid = solenoidOf(edge);
        const int time_us = timeOf(pulses_, edge);
        const double x = along.pixelOf(std::min(time_us, along.span_us));
        // Of a pulse that is none only the line is there to lie on.
        const bool isPulse = (solenoid == 1 ? pulses_.width1_us : pulses_.width2_us) > 0;
        const double y = baseOf(solenoid) - (isPulse ? kPulseHeight / 2 : 0);
        handle->move(static_cast<int>(x) - PulseHandle::kSize / 2,
                     static_cast<int>(y) - PulseHandle::kSize / 2);
        const QString& label = labels_[static_cast<std::size_t>(solenoid - 1)];
        const QString name = (isStart(edge) ? tr("%1, begins at %2 \u00b5s") : tr("%1, ends at %2 \u00b5s"))
                                 .arg(label)
                                 .arg(time_us);
        handle->setAccessibleName(name);
        handle->setToolTip(
            tr("%1. Pull it, or use the arrow keys (32 \u00b5s) and Page keys (320 \u00b5s).").arg(name));
        // The falling edge lies over the leading one where both are in one place.
        if (!isStart(edge)) handle->raise();
        handle->setVisible(canPull(pulses_, edge));
    }
}

void KickPulsesView::pull(PulseEdge edge, int time_us) {
    const wire::KickPulses wanted = pulled(pulses_, edge, time_us);
    if (wanted != pulses_) emit asked(wanted);
}

void KickPulsesView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeHandles();
}

void KickPulsesView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.background);
    painter.drawRoundedRect(rect(), metrics::kControlRadius, metrics::kControlRadius);
    paintScale(painter);
    paintPulse(painter, 1);
    paintPulse(painter, 2);
}

void KickPulsesView::paintScale(QPainter& painter) const {
    const Tokens& t = tokensOf(palette());
    const PulseAxis along = axis();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setFont(numberFont(metrics::kSmallTextSize));
    for (int time_ms = 0; time_ms <= 4; ++time_ms) {
        const int x = static_cast<int>(along.pixelOf(time_ms * 1000));
        painter.setPen(t.line);
        painter.drawLine(x, 6, x, kHeight - kScaleHeight - 2);
        painter.setPen(t.muted);
        painter.drawText(QRect(x - 30, kHeight - kScaleHeight, 60, kScaleHeight - 2), Qt::AlignCenter,
                         time_ms == 0 ? QStringLiteral("0") : tr("%1 ms").arg(time_ms));
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void KickPulsesView::paintPulse(QPainter& painter, int solenoid) const {
    const Tokens& t = tokensOf(palette());
    const PulseAxis along = axis();
    const bool first = solenoid == 1;
    const int start_us = timeOf(pulses_, first ? PulseEdge::Start1 : PulseEdge::Start2);
    const int end_us = timeOf(pulses_, first ? PulseEdge::End1 : PulseEdge::End2);
    const double base = baseOf(solenoid);
    const double top = base - kPulseHeight;
    const double from = along.pixelOf(std::min(start_us, along.span_us));
    const double to = along.pixelOf(std::min(end_us, along.span_us));
    const bool tooLate = end_us > wire::kKickMax_us;
    const QColor colour = tooLate || !isEnabled() ? (tooLate ? t.warn : t.muted) : colourOf(solenoid, t.dark);
    QColor fill = colour;
    fill.setAlphaF(0.16F);
    painter.fillRect(QRectF(from, top, to - from, kPulseHeight),
                     tooLate ? QBrush(colour, Qt::BDiagPattern) : QBrush(fill));
    QPainterPath line(QPointF(8, base));
    line.lineTo(from, base);
    line.lineTo(from, end_us > start_us ? top : base);
    line.lineTo(to, end_us > start_us ? top : base);
    // What goes on past the last edge that exists has no end to draw.
    if (!tooLate) line.lineTo(to, base);
    if (!tooLate) line.lineTo(width() - 8, base);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(line);
    painter.setFont(textFont(metrics::kSmallTextSize));
    // On its line's far end, where a pulse seldom is; under the line where it is.
    const QString& label = labels_[static_cast<std::size_t>(solenoid - 1)];
    const int label_px = painter.fontMetrics().horizontalAdvance(label);
    const bool covered = to > width() - kRightMargin - label_px - 12;
    painter.drawText(
        QRectF(width() - kRightMargin - label_px, covered ? base + 1 : top + 5, label_px + 2, 16),
        Qt::AlignVCenter, label);
}

PulseHandle::PulseHandle(PulseEdge edge, KickPulsesView* view) : QWidget(view), view_(*view), edge_(edge) {
    setObjectName(QString::fromLatin1(nameOf(edge)));
    setFixedSize(kSize, kSize);
    setCursor(Qt::SizeHorCursor);
    setFocusPolicy(Qt::StrongFocus);
}

void PulseHandle::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    const QPointF centre(kSize / 2.0, kSize / 2.0);
    if (hasFocus()) {
        painter.setPen(Qt::NoPen);
        QColor ring = t.accent;
        ring.setAlphaF(0.3F);
        painter.setBrush(ring);
        painter.drawEllipse(centre, kKnob + 4, kKnob + 4);
    }
    painter.setPen(QPen(isEnabled() ? colourOf(solenoidOf(edge_), t.dark) : t.muted, 1.5));
    painter.setBrush(t.surface);
    painter.drawEllipse(centre, kKnob, kKnob);
}

void PulseHandle::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    held_ = true;
    const PulseAxis along = view_.axis();
    grip_px_ = mapTo(&view_, event->position()).x() -
               along.pixelOf(std::min(timeOf(view_.pulses(), edge_), along.span_us));
}

void PulseHandle::mouseMoveEvent(QMouseEvent* event) {
    if (!held_) return;
    view_.pull(edge_, view_.axis().timeOf(mapTo(&view_, event->position()).x() - grip_px_));
}

void PulseHandle::mouseReleaseEvent(QMouseEvent*) {
    held_ = false;
}

void PulseHandle::keyPressEvent(QKeyEvent* event) {
    int steps = 0;
    switch (event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Down:
            steps = -1;
            break;
        case Qt::Key_Right:
        case Qt::Key_Up:
            steps = 1;
            break;
        case Qt::Key_PageDown:
            steps = -kPageSteps;
            break;
        case Qt::Key_PageUp:
            steps = kPageSteps;
            break;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    view_.pull(edge_, timeOf(view_.pulses(), edge_) + steps * wire::kKickStep_us);
}

void PulseHandle::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void PulseHandle::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

}  // namespace kickstand::ui
