#pragma once

#include <QPushButton>

namespace kickstand::ui {

/// The big red button. It acts when it is pressed, not when it is let go, and it never has the focus. Once
/// everything is stopped it says so, and can still be pressed.
class StopButton final : public QPushButton {
    Q_OBJECT
  public:
    explicit StopButton(QWidget* parent = nullptr);

    void setStopped(bool stopped);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    bool stopped_ = false;
};

}  // namespace kickstand::ui
