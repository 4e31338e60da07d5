#pragma once

#include <QWidget>

#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// The bytes of an experiment buffer over their offset, 0 to 255 both ways. What has not arrived is hatched.
class ExperimentPlot final : public QWidget {
    Q_OBJECT
  public:
    explicit ExperimentPlot(QWidget* parent = nullptr);

    void setBuffer(const thunderbots::ExperimentBuffer& buffer);

    QSize sizeHint() const override { return {240, 160}; }
    QSize minimumSizeHint() const override { return {160, 100}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF area() const;
    void drawGrid(QPainter& painter) const;
    void drawGaps(QPainter& painter) const;
    void drawBytes(QPainter& painter) const;

    thunderbots::ExperimentBuffer buffer_;
};

}  // namespace kickstand::ui
