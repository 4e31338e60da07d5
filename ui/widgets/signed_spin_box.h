#pragma once

#include <QSpinBox>

namespace kickstand::ui {

/// A whole number with a typographic minus, the keyboard alone (no arrows, no wheel unless it has the focus).
/// What is typed counts when Enter is pressed; leaving the field gives the old number back: nothing moves
/// because somebody clicked elsewhere.
class SignedSpinBox final : public QSpinBox {
    Q_OBJECT
  public:
    explicit SignedSpinBox(QWidget* parent = nullptr);

  protected:
    bool event(QEvent* event) override;
    QString textFromValue(int value) const override;
    int valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    void focusOutEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
};

}  // namespace kickstand::ui
