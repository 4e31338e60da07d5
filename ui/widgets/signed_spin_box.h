#pragma once

#include <QSpinBox>
#include <optional>

namespace kickstand::ui {

/// A whole number with a typographic minus, the keyboard alone (no arrows, no wheel unless it has the focus).
/// What is typed counts when Enter is pressed or the field is left; where it would move something, Enter
/// alone: nothing moves because somebody clicked elsewhere.
class SignedSpinBox final : public QSpinBox {
    Q_OBJECT
  public:
    explicit SignedSpinBox(QWidget* parent = nullptr);

    /// Shows the value with so many places after the point: 235 as "2.35".
    void setDecimals(int decimals);
    /// Leaving the field gives the old number back instead of confirming what was typed: for what moves.
    void setLeavingGivesBack(bool givesBack) { leavingGivesBack_ = givesBack; }
    /// Shows a value; what is being typed stays while it is the same.
    void showValue(int value);

  protected:
    bool event(QEvent* event) override;
    QString textFromValue(int value) const override;
    int valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    void focusOutEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    /// The value that a text stands for, whether it is in range or not; none for what is no number.
    std::optional<qint64> parse(const QString& text) const;

    int decimals_ = 0;
    bool leavingGivesBack_ = false;
};

}  // namespace kickstand::ui
