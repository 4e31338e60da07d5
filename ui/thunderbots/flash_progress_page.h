#pragma once

#include <array>

#include "ui/thunderbots/flash_page.h"
#include "ui/thunderbots/flash_run.h"

class QProgressBar;

namespace kickstand::ui {

class StateLabel;

/// The wizard's fourth page: a row for each robot, and what STOP has paused.
class FlashProgressPage final : public FlashPageView {
    Q_OBJECT
  public:
    explicit FlashProgressPage(QWidget* parent = nullptr);

    /// `stopped`: STOP is latched.
    void showState(const FlashRun& run, bool stopped);

  signals:
    void cancelAsked(thunderbots::RobotMask robots);
    void resumeAsked(thunderbots::RobotMask robots);

  private:
    struct Row {
        QWidget* all = nullptr;
        StateLabel* stage = nullptr;
        QProgressBar* bar = nullptr;
        QLabel* figures = nullptr;
        QPushButton* cancel = nullptr;
    };
    Row makeRow(int robot);
    void makePause();
    void showRow(const Row& row, const FlashRunRobot& entry);
    void showPause(const FlashRun& run, bool stopped);

    std::array<Row, thunderbots::kRobots> rows_;
    QLabel* summary_;
    QPushButton* cancelAll_;
    QWidget* pause_ = nullptr;
    QLabel* paused_ = nullptr;
    QPushButton* resume_ = nullptr;
    thunderbots::RobotMask running_ = 0;
    thunderbots::RobotMask pausedRobots_ = 0;
};

}  // namespace kickstand::ui
