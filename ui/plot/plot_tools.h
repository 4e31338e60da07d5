#pragma once

#include <QWidget>

class QPushButton;

namespace kickstand::ui {

class Segmented;
class TimePlot;

/// What every plot's header has: pause and follow, the span of time and the range of values, and cursors. GUI
/// thread.
class PlotTools final : public QWidget {
    Q_OBJECT
  public:
    /// `plot` outlives it. Its controls' names begin with `name`.
    PlotTools(TimePlot& plot, const QString& name, QWidget* parent = nullptr);

  signals:
    /// A person has chosen a span from the menu.
    void spanChosen(int span_s);

  private:
    QPushButton* makeSpan(const QString& name);
    void refresh();

    TimePlot& plot_;
    Segmented* running_;
    QPushButton* span_;
    QPushButton* cursors_;
};

}  // namespace kickstand::ui
