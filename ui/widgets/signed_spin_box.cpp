#include "ui/widgets/signed_spin_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QWheelEvent>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr QChar kMinus(0x2212);

QString plain(QString text) {
    return text.replace(kMinus, u'-').trimmed();
}

}  // namespace

SignedSpinBox::SignedSpinBox(QWidget* parent) : QSpinBox(parent) {
    setButtonSymbols(NoButtons);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus);
    setCorrectionMode(CorrectToNearestValue);
}

bool SignedSpinBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // A letter is no number: it stays a shortcut while the field has the focus.
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && key->key() >= Qt::Key_A && key->key() <= Qt::Key_Z) {
            event->ignore();
            return false;
        }
    }
    return QSpinBox::event(event);
}

QString SignedSpinBox::textFromValue(int value) const {
    return signedNumber(value);
}

int SignedSpinBox::valueFromText(const QString& text) const {
    return plain(text).toInt();
}

QValidator::State SignedSpinBox::validate(QString& text, int&) const {
    const QString number = plain(text);
    if (number.isEmpty() || number == u"-") return QValidator::Intermediate;
    bool isNumber = false;
    const qlonglong wanted = number.toLongLong(&isNumber);
    if (!isNumber || number.contains(u'+')) return QValidator::Invalid;
    // A number past the end can still be shortened; Enter takes it to the nearest end.
    return wanted >= minimum() && wanted <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

void SignedSpinBox::fixup(QString& text) const {
    bool isNumber = false;
    const qlonglong number = plain(text).toLongLong(&isNumber);
    const qlonglong nearest = qBound(qlonglong{minimum()}, number, qlonglong{maximum()});
    text = textFromValue(isNumber ? static_cast<int>(nearest) : value());
}

void SignedSpinBox::focusOutEvent(QFocusEvent* event) {
    lineEdit()->setText(textFromValue(value()));
    QSpinBox::focusOutEvent(event);
}

void SignedSpinBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus()) {
        QSpinBox::wheelEvent(event);
    } else {
        event->ignore();
    }
}

}  // namespace kickstand::ui
