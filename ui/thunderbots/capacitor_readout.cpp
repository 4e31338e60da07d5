#include "ui/thunderbots/capacitor_readout.h"

#include <QPainter>
#include <algorithm>
#include <bit>

#include "core/thunderbots/wire/readings.h"
#include "ui/thunderbots/tile_content.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kNumberSize = 28;
constexpr int kNumberHeight = 36;
constexpr double kBarHeight = 4;
constexpr int kCaptionHeight = 18;

/// The part of the bar that a voltage fills; its end is where kCapacitorChargedMark has it too.
double partOf(double volts) {
    return std::clamp(volts * kCapacitorChargedMark / thunderbots::wire::kCapacitorCharged_V, 0.0, 1.0);
}

}  // namespace

CapacitorReadout::CapacitorReadout(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("capacitor"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    showState({}, {});
}

void CapacitorReadout::showState(const ChoiceSummary& summary, TimePoint now) {
    const double volts = summary.capacitor_V.value_or(0);
    QString number = summary.capacitor_V ? capacitorText(volts) : QStringLiteral("\u2014");
    // Never an old number that looks fresh.
    if (summary.capacitor_V && summary.capacitorStale) number += u'?';
    const bool live = volts >= thunderbots::wire::kCapacitorLive_V;
    QString caption = tr("no capacitor is known");
    if (summary.capacitor_V) {
        caption = tr("robot %1's capacitor").arg(summary.capacitorRobot);
        if (std::popcount(summary.chosen) > 1)
            caption = tr("highest of those chosen: robot %1").arg(summary.capacitorRobot);
        if (live && summary.capacitorStale)
            caption += tr(" \u00b7 %1 ago: treat as live").arg(ageText(now - summary.capacitorSeen));
        else if (live)
            caption += tr(" \u00b7 live");
    }
    if (number == number_ && caption == caption_ && live == live_) return;
    number_ = number;
    caption_ = caption;
    live_ = live;
    level_ = partOf(volts);
    setAccessibleName(tr("Capacitor %1, %2").arg(number_, caption_));
    update();
}

QSize CapacitorReadout::sizeHint() const {
    return {200, kNumberHeight + 8 + kCaptionHeight};
}

void CapacitorReadout::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    painter.setFont(numberFont(kNumberSize, QFont::DemiBold));
    painter.setPen(live_ ? t.danger : t.text);
    painter.drawText(QRect(0, 0, width(), kNumberHeight), Qt::AlignVCenter, number_);
    if (live_) {
        const int x = painter.fontMetrics().horizontalAdvance(number_) + 8;
        drawBolt(painter, QRectF(x, 7, 15, 22), t.danger);
    }
    drawLevel(painter, QRectF(0, kNumberHeight, width(), kBarHeight),
              {level_, kCapacitorLiveMark, kCapacitorChargedMark}, live_ ? t.danger : t.muted, t.line,
              t.muted);
    painter.setFont(textFont(metrics::kSmallTextSize));
    painter.setPen(live_ ? t.danger : t.muted);
    painter.drawText(QRect(0, height() - kCaptionHeight, width(), kCaptionHeight), Qt::AlignVCenter,
                     caption_);
}

}  // namespace kickstand::ui
