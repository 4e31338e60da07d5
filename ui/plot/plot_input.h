#pragma once

#include <QObject>
#include <QPointF>

class QCustomPlot;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace kickstand::ui {

class TimePlot;

/// What mouse and keys do to a plot.
class PlotInput final : public QObject {
    Q_OBJECT
  public:
    /// The plot owns it.
    PlotInput(TimePlot& plot, QCustomPlot& canvas);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Drag { None, Time, Values, Cursor };

    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool wheel(const QWheelEvent& event);
    bool key(const QKeyEvent& event);
    bool valueKey(int key, bool control);
    bool cursorKey(int key, bool fast);
    void hover(const QPointF& at);
    void goToMark(bool next);
    double placeOf(double x) const;

    TimePlot& plot_;
    QCustomPlot& canvas_;
    Drag drag_ = Drag::None;
    QPointF last_;
    double rest_ = 0;  ///< Of a column, that the mouse has moved and the view not yet.
    int area_ = 0;
    int cursor_ = 0;
};

}  // namespace kickstand::ui
