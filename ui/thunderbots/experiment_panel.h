#pragma once

#include "core/thunderbots/snapshot.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/experiment_bytes.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace kickstand::ui {

class ExperimentPlot;
class RobotChoice;

/// What a robot has sent of its experiment buffer, as it arrives: a table, a plot, and a file.
class ExperimentPanel final : public Panel {
    Q_OBJECT
  public:
    ExperimentPanel(Bench& bench, RobotChoice& choice, QWidget* parent = nullptr);

    QWidget* headerTools() override;

  private:
    void buildTable();
    void refresh();
    void refreshRobots(const thunderbots::Snapshot& snapshot);
    void followChoice();
    int robot() const;
    void clear();
    void copy();
    void save();

    RobotChoice& choice_;
    ExperimentBytes model_;
    QTableView* table_;
    ExperimentPlot* plot_;
    QLabel* state_;
    QLabel* refused_;
    QComboBox* robots_ = nullptr;
    QPushButton* copy_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* clear_ = nullptr;
};

}  // namespace kickstand::ui
