#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

namespace kickstand::ui {

/// One state of a chart.
struct ChartState {
    QString name;
    bool current = false;
};
/// A timer that runs: what it does, and which part of it is over (0-1).
struct ChartTimer {
    QString name;
    double over = 0;
    double left_s = 0;
};

/// The states of one side in a row, the one that it is in marked, with the timers that run below.
class ChartView final : public QWidget {
    Q_OBJECT
  public:
    explicit ChartView(QWidget* parent = nullptr);

    void show(std::vector<ChartState> states, std::vector<ChartTimer> timers);

    QSize sizeHint() const override { return {480, 120}; }
    QSize minimumSizeHint() const override { return {320, 112}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void drawStates(QPainter& painter, const QRectF& row);
    void drawTimers(QPainter& painter, const QRectF& row);

    std::vector<ChartState> states_;
    std::vector<ChartTimer> timers_;
};

}  // namespace kickstand::ui
