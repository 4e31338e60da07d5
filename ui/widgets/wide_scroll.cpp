#include "ui/widgets/wide_scroll.h"

#include <QEvent>
#include <QScrollBar>

namespace kickstand::ui {

WideScroll::WideScroll(QWidget* content, QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setWidget(content);
    viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
}

QSize WideScroll::sizeHint() const {
    return widget()->sizeHint() + QSize(0, horizontalScrollBar()->sizeHint().height());
}

QSize WideScroll::minimumSizeHint() const {
    return {0, sizeHint().height()};
}

bool WideScroll::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

}  // namespace kickstand::ui
