#pragma once

#include <QWidget>

class QLabel;

namespace kickstand::ui {

class CenterSlider;
class SignedSpinBox;

/// One set point: its name, a slider with zero in the middle, a number, and what the number means. It shows
/// what it is told; `asked` is what a person wants.
class SetPointSlider final : public QWidget {
    Q_OBJECT
  public:
    explicit SetPointSlider(const QString& name, QWidget* parent = nullptr);

    void setLimit(int limit);
    int limit() const;
    /// Shows a set point without asking for anything. Ignored while a person pulls the slider or types.
    void showValue(int value);
    /// Shows how far the thing behind has come towards it.
    void setReached(int value);
    void setMeaning(const QString& text);
    QString meaning() const;
    /// Shows the number with so many places after the point: 235 as "2.35".
    void setDecimals(int decimals);
    /// Whether the slider springs back to zero when it is let go.
    void setReleaseToZero(bool on) { releaseToZero_ = on; }
    int value() const;
    /// Whether a person is at it.
    bool isHeld() const;
    /// Ends a pull, and sets the shown value to zero without asking for anything.
    void reset();

    CenterSlider* slider() const { return slider_; }
    SignedSpinBox* field() const { return field_; }

  signals:
    /// A person wants this value. `held`: only as long as the slider is held.
    void asked(int value, bool held);

  private:
    void sliderMoved(int value);
    void sliderReleased();
    void ask(int value, bool held);

    CenterSlider* slider_;
    SignedSpinBox* field_;
    QLabel* meaning_;
    bool releaseToZero_ = true;
    bool telling_ = false;
};

}  // namespace kickstand::ui
