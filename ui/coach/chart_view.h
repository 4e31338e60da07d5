#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

namespace kickstand::ui {

/// One state of a chart, and where it stands: in columns from the left and rows from the top.
struct ChartState {
    QString name;
    double column = 0;
    int row = 0;
    bool current = false;
};
/// A transition between two states, by their places in the list, and what fires it.
struct ChartArrow {
    std::size_t from = 0;
    std::size_t to = 0;
    QString fires;
    bool below = false;  ///< Goes below everything else, where others stand between the two.
};
/// A timer that runs: what it does when it is over, and which part of it is over (0-1).
struct ChartTimer {
    QString name;
    double over = 0;
    double left_s = 0;
};
struct Chart {
    std::vector<ChartState> states;
    std::vector<ChartArrow> arrows;
    std::vector<ChartTimer> timers;
    /// From where to where, in columns, the timers stand in the lower row: where no arrow is.
    double timersColumn = 0;
    double timersEnd = 1;
};

/// A state chart of two rows: what the states are, the one that it is in lit, what leads from one to another,
/// and the timers that run.
class ChartView final : public QWidget {
    Q_OBJECT
  public:
    explicit ChartView(QWidget* parent = nullptr);

    void show(Chart chart);
    const Chart& chart() const { return chart_; }

    QSize sizeHint() const override { return {720, 148}; }
    QSize minimumSizeHint() const override { return {560, 148}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF boxOf(const ChartState& state) const;
    void drawState(QPainter& painter, const ChartState& state) const;
    void drawArrow(QPainter& painter, const ChartArrow& arrow) const;
    void drawAcross(QPainter& painter, const QRectF& from, const QRectF& to, const QString& fires) const;
    void drawBelow(QPainter& painter, const QRectF& from, const QRectF& to, const QString& fires) const;
    void drawUp(QPainter& painter, const QRectF& from, const QRectF& to, const QString& fires) const;
    void drawDown(QPainter& painter, const QRectF& from, const QRectF& to, const QString& fires) const;
    void drawTimers(QPainter& painter) const;

    Chart chart_;
};

}  // namespace kickstand::ui
