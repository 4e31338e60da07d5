#include "ui/shell/stop_button.h"

#include <QPainter>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kWidth = 148;
constexpr int kHeight = 36;
constexpr int kSquare = 10;
constexpr int kSpacing = 8;

}  // namespace

StopButton::StopButton(QWidget* parent) : QPushButton(parent) {
    setObjectName(QStringLiteral("stop"));
    setFocusPolicy(Qt::NoFocus);
    setAutoDefault(false);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setToolTip(
        tr("Brakes every robot, and switches charger, dribbler and autokick off. Space or Esc, anywhere."));
    setStopped(false);
}

void StopButton::setStopped(bool stopped) {
    stopped_ = stopped;
    setText(stopped ? tr("STOPPED") : tr("STOP"));
    setAccessibleName(stopped ? tr("Stopped. Stop again.") : tr("Stop everything"));
    update();
}

QSize StopButton::sizeHint() const {
    return {kWidth, kHeight};
}

void StopButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    const QColor ink = stopped_ ? t.danger : t.onDanger;
    QColor fill = stopped_ ? t.dangerSoft : t.danger;
    if (isDown() || underMouse()) fill = fill.darker(isDown() ? 120 : 108);
    painter.setPen(QPen(t.danger, stopped_ ? 2 : 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(box, metrics::kControlRadius, metrics::kControlRadius);

    QFont strong = font();
    strong.setWeight(QFont::Bold);
    strong.setLetterSpacing(QFont::PercentageSpacing, 104);
    const QFontMetrics strongMetrics(strong);
    const QString word = text();
    const QString key = stopped_ ? QString() : tr("Space");
    const int keyWidth = key.isEmpty() ? 0 : kSpacing + fontMetrics().horizontalAdvance(key);
    const int total = kSquare + kSpacing + strongMetrics.horizontalAdvance(word) + keyWidth;
    int x = (width() - total) / 2;
    painter.fillRect(QRectF(x, (height() - kSquare) / 2.0, kSquare, kSquare), ink);
    x += kSquare + kSpacing;
    painter.setPen(ink);
    painter.setFont(strong);
    painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter, word);
    if (key.isEmpty()) return;
    painter.setFont(font());
    painter.setOpacity(0.85);
    x += strongMetrics.horizontalAdvance(word) + kSpacing;
    painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter, key);
}

}  // namespace kickstand::ui
