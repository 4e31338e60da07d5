#include "ui/shell/stopped_frame.h"

#include <QPainter>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kWidth = 3;

}  // namespace

StoppedFrame::StoppedFrame(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void StoppedFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(QPen(tokensOf(palette()).danger, kWidth));
    const double inset = kWidth / 2.0;
    painter.drawRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset));
}

}  // namespace kickstand::ui
