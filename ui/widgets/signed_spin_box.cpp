#include "ui/widgets/signed_spin_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QWheelEvent>
#include <cmath>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr QChar kMinus(0x2212);
/// Past any range, and still a whole number.
constexpr double kLargest = 1e15;

QString plain(QString text) {
    return text.replace(kMinus, u'-').replace(u',', u'.').trimmed();
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

void SignedSpinBox::setDecimals(int decimals) {
    decimals_ = decimals;
    lineEdit()->setText(textFromValue(value()));
}

void SignedSpinBox::showValue(int value) {
    // Setting what it has already would throw away what is being typed.
    if (value != this->value()) setValue(value);
}

std::optional<qint64> SignedSpinBox::parse(const QString& text) const {
    bool isNumber = false;
    if (decimals_ == 0) {
        const qint64 whole = text.toLongLong(&isNumber);
        return isNumber ? std::optional(whole) : std::nullopt;
    }
    const double number = text.toDouble(&isNumber) * std::pow(10, decimals_);
    if (!isNumber || !(std::abs(number) < kLargest)) return std::nullopt;
    return std::llround(number);
}

QString SignedSpinBox::textFromValue(int value) const {
    if (decimals_ == 0) return signedNumber(value);
    return QString::number(value / std::pow(10, decimals_), 'f', decimals_).replace(u'-', kMinus);
}

int SignedSpinBox::valueFromText(const QString& text) const {
    return static_cast<int>(qBound(qint64{minimum()}, parse(plain(text)).value_or(0), qint64{maximum()}));
}

QValidator::State SignedSpinBox::validate(QString& text, int&) const {
    const QString number = plain(text);
    if (number.isEmpty() || number == u"-") return QValidator::Intermediate;
    if (decimals_ > 0 && (number == u"." || number == u"-.")) return QValidator::Intermediate;
    const auto wanted = parse(number);
    if (!wanted || number.contains(u'+') || number.contains(u'e', Qt::CaseInsensitive))
        return QValidator::Invalid;
    // A number past the end can still be shortened; Enter takes it to the nearest end.
    return *wanted >= minimum() && *wanted <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

void SignedSpinBox::fixup(QString& text) const {
    const auto number = parse(plain(text));
    const qint64 nearest = qBound(qint64{minimum()}, number.value_or(value()), qint64{maximum()});
    text = textFromValue(static_cast<int>(nearest));
}

void SignedSpinBox::focusOutEvent(QFocusEvent* event) {
    if (leavingGivesBack_) lineEdit()->setText(textFromValue(value()));
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
