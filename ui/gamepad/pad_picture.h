#pragma once

#include <QWidget>
#include <vector>

#include "ui/gamepad/stick_curve.h"

namespace kickstand::ui {

/// A stick's curve with its dead zone, and where the sticks stand on it now.
class PadPicture final : public QWidget {
    Q_OBJECT
  public:
    explicit PadPicture(QWidget* parent = nullptr);

    /// `positions`: of each stick, −1 to 1, before the curve.
    void show(const StickCurve& curve, const std::vector<double>& positions, bool counts);

    QSize sizeHint() const override { return {150, 150}; }
    QSize minimumSizeHint() const override { return {110, 110}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF area() const;
    QPointF place(double position) const;

    StickCurve curve_;
    std::vector<double> positions_;
    bool counts_ = false;
};

}  // namespace kickstand::ui
