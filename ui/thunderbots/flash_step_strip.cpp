#include "ui/thunderbots/flash_step_strip.h"

#include <QPainter>

#include "ui/thunderbots/flash_words.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kHeight = 24;
constexpr int kDisc = 20;
constexpr int kDiscGap = 6;
constexpr int kLeastLine = 12;

QFont fontOf(bool current) {
    return textFont(metrics::kTextSize, current ? QFont::DemiBold : QFont::Normal);
}

/// As wide as it can get.
int widthOf(FlashStep step) {
    return kDisc + kDiscGap + QFontMetrics(fontOf(true)).horizontalAdvance(flashStepText(step));
}

void drawDisc(QPainter& painter, const QRectF& disc, int number, FlashStep current, const Tokens& t) {
    const int reached = static_cast<int>(current);
    const bool filled = number <= reached;
    painter.setPen(QPen(filled ? t.accent : t.line, 1));
    painter.setBrush(number == reached ? t.accent : filled ? t.accentSoft : t.surface);
    painter.drawEllipse(disc);
    painter.setPen(number == reached ? t.onAccent : filled ? t.accent : t.muted);
    painter.setFont(numberFont(metrics::kSmallTextSize, QFont::DemiBold));
    painter.drawText(disc, Qt::AlignCenter,
                     number < reached ? QStringLiteral("\u2713") : QString::number(number + 1));
}

}  // namespace

FlashStepStrip::FlashStepStrip(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("flashSteps"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setStep(FlashStep::Robots);
}

void FlashStepStrip::setStep(FlashStep step) {
    step_ = step;
    const QString words =
        tr("Step %1 of %2: %3").arg(static_cast<int>(step) + 1).arg(kFlashSteps).arg(flashStepText(step));
    if (words == accessibleName()) return;
    setAccessibleName(words);
    update();
}

QSize FlashStepStrip::sizeHint() const {
    int width = 0;
    for (int number = 0; number < kFlashSteps; ++number)
        width += widthOf(static_cast<FlashStep>(number)) + (number > 0 ? kLeastLine + 2 * kDiscGap : 0);
    return {width, kHeight};
}

void FlashStepStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    const int room = width() - sizeHint().width();
    const int line = kLeastLine + room / (kFlashSteps - 1);
    int x = 0;
    for (int number = 0; number < kFlashSteps; ++number) {
        const auto step = static_cast<FlashStep>(number);
        if (number > 0) {
            painter.setPen(QPen(t.line, 1));
            painter.drawLine(QPointF(x + kDiscGap, height() / 2.0),
                             QPointF(x + kDiscGap + line, height() / 2.0));
            x += line + 2 * kDiscGap;
        }
        drawDisc(painter, QRectF(x + 0.5, (height() - kDisc) / 2.0 + 0.5, kDisc - 1, kDisc - 1), number,
                 step_, t);
        painter.setFont(fontOf(step == step_));
        painter.setPen(number <= static_cast<int>(step_) ? t.text : t.muted);
        painter.drawText(QRect(x + kDisc + kDiscGap, 0, widthOf(step), height()),
                         Qt::AlignVCenter | Qt::AlignLeft, flashStepText(step));
        x += widthOf(step);
    }
}

}  // namespace kickstand::ui
