#pragma once

#include <QWidget>
#include <vector>

#include "ui/plot/plot_contents.h"
#include "ui/plot/trigger.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace kickstand::ui {

/// Says what the plot is to wait for: which curve, which way, which level.
class VoltagesTrigger final : public QWidget {
    Q_OBJECT
  public:
    explicit VoltagesTrigger(QWidget* parent = nullptr);

    /// What can be waited for. The one that was chosen stays, where it is still there.
    void setCurves(const std::vector<PlotCurve>& curves, const std::vector<PlotArea>& areas);
    /// How it stands: "waiting…", "caught at 12:04:03.118".
    void setState(const QString& state, bool waiting);

  signals:
    void armed(kickstand::SignalId signal, kickstand::ui::Edge edge, double level);

  private:
    void chooseCurve();
    void arm();

    QComboBox* curve_;
    QComboBox* edge_;
    QDoubleSpinBox* level_;
    QPushButton* arm_;
    QLabel* state_;
    std::vector<PlotCurve> curves_;
    std::vector<PlotArea> areas_;
    int area_ = -1;
};

}  // namespace kickstand::ui
