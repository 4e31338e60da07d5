#pragma once

#include <QTimer>

#include "core/thunderbots/snapshot.h"
#include "ui/shell/panel.h"

class QLabel;

namespace kickstand::ui {

class RobotChoice;
class RobotGrid;

/// The sixteen robots at a glance, and the choice of those that are driven.
class RobotsPanel final : public Panel {
    Q_OBJECT
  public:
    RobotsPanel(Bench& bench, RobotChoice& choice, QWidget* parent = nullptr);

    RobotGrid* grid() const { return grid_; }

  private:
    void refresh();
    QString hintFor(const thunderbots::Snapshot& snapshot, int heard) const;

    RobotChoice& choice_;
    RobotGrid* grid_;
    QLabel* hint_;
    QTimer ages_;
};

}  // namespace kickstand::ui
