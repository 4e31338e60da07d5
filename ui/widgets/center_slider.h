#pragma once

#include <QAbstractSlider>

namespace kickstand::ui {

/// A slider whose zero is in the middle and whose track is filled from there. It is pulled, not jumped:
/// wherever it is pressed, the value moves with the pointer from where it was, so that a press alone never
/// sets anything in motion. A key that is held pulls it too, until it is let go; one that is tapped does not.
/// The mouse wheel is left to the page.
class CenterSlider final : public QAbstractSlider {
    Q_OBJECT
  public:
    explicit CenterSlider(QWidget* parent = nullptr);

    /// How far the thing behind it has come towards the value.
    void setReached(int value);
    int reached() const { return reached_; }
    /// Ends a pull as if the button had been let go.
    void letGo();
    /// Where the thumb of a value is, in this widget's coordinates.
    double positionOf(int value) const;

    QSize sizeHint() const override { return {160, 24}; }
    QSize minimumSizeHint() const override { return {72, 24}; }

  signals:
    void zeroAsked();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    int reached_ = 0;
    double pressedAt_ = 0;
    int valueAtPress_ = 0;
};

}  // namespace kickstand::ui
