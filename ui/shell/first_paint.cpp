#include "ui/shell/first_paint.h"

#include <QEvent>
#include <QTimer>
#include <QWidget>

namespace kickstand::ui {

FirstPaint::FirstPaint(QWidget& window) : QObject(&window) {
    window.installEventFilter(this);
}

bool FirstPaint::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint) {
        watched->removeEventFilter(this);
        // After the event that it is in the middle of, which paints the rest of the window.
        QTimer::singleShot(0, this, &FirstPaint::painted);
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace kickstand::ui
