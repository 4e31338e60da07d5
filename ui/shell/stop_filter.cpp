#include "ui/shell/stop_filter.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace kickstand::ui {

namespace {

/// Whether a space typed now would become text. A number field has no use for one.
bool typesText(const QWidget* focus) {
    if (const auto* line = qobject_cast<const QLineEdit*>(focus)) return !line->isReadOnly();
    if (const auto* text = qobject_cast<const QTextEdit*>(focus)) return !text->isReadOnly();
    if (const auto* text = qobject_cast<const QPlainTextEdit*>(focus)) return !text->isReadOnly();
    if (const auto* combo = qobject_cast<const QComboBox*>(focus)) return combo->isEditable();
    return false;
}

}  // namespace

StopFilter::StopFilter(std::function<bool()> isActive, QObject* parent)
    : QObject(parent), isActive_(std::move(isActive)) {
    qApp->installEventFilter(this);
}

bool StopFilter::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease &&
        event->type() != QEvent::ShortcutOverride) {
        return QObject::eventFilter(watched, event);
    }
    auto* key = static_cast<QKeyEvent*>(event);
    if (isStop(*key)) {
        // Nobody else sees any of it: a release alone would press a button too.
        if (event->type() == QEvent::KeyPress && !key->isAutoRepeat()) emit stopAsked();
        event->accept();
        return true;
    }
    // A press passes the window first; it is for the widget that is to be pressed.
    if (event->type() == QEvent::KeyPress && watched->isWidgetType() && pressButton(*key)) return true;
    return QObject::eventFilter(watched, event);
}

bool StopFilter::isStop(const QKeyEvent& event) const {
    if (event.key() == Qt::Key_Space) return isActive_() || !typesText(QApplication::focusWidget());
    if (event.key() == Qt::Key_Escape) {
        const bool closes =
            QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr;
        return isActive_() || !closes;
    }
    return false;
}

bool StopFilter::pressButton(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter) return false;
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    if (event.isAutoRepeat() || modifiers != Qt::NoModifier) return false;
    if (QApplication::activePopupWidget() != nullptr) return false;
    auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget());
    if (button == nullptr || !button->isEnabled()) return false;
    button->click();
    return true;
}

}  // namespace kickstand::ui
