#pragma once

#include <array>

#include "ui/thunderbots/flash_page.h"
#include "ui/thunderbots/flash_run.h"

namespace kickstand::ui {

class StateLabel;

/// The wizard's last page: how it ended for each robot, in one plain sentence, and its log.
class FlashResultPage final : public FlashPageView {
    Q_OBJECT
  public:
    explicit FlashResultPage(QWidget* parent = nullptr);

    void showState(const FlashRun& run);

  signals:
    /// The logs of these robots are to be saved in one file.
    void logAsked(thunderbots::RobotMask robots);
    void againAsked(thunderbots::RobotMask robots);

  private:
    struct Row {
        QWidget* all = nullptr;
        StateLabel* outcome = nullptr;
        QLabel* sentence = nullptr;
    };
    Row makeRow(int robot);

    std::array<Row, thunderbots::kRobots> rows_;
    QLabel* summary_;
    QPushButton* logs_;
    QPushButton* again_;
    thunderbots::RobotMask robots_ = 0;
    thunderbots::RobotMask unfinished_ = 0;
};

}  // namespace kickstand::ui
