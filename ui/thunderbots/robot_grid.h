#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/thunderbots/snapshot.h"
#include "ui/thunderbots/tile_marks.h"

namespace kickstand::ui {

class RobotChoice;
class RobotTile;

/// Sixteen tiles in two columns, all of them always visible. Those that have been heard come first; nothing
/// changes places under the pointer.
class RobotGrid final : public QWidget {
    Q_OBJECT
  public:
    explicit RobotGrid(RobotChoice& choice, QWidget* parent = nullptr);

    void showState(const thunderbots::Snapshot& snapshot, TimePoint now);
    RobotTile* tile(int robot) const { return tiles_[static_cast<std::size_t>(robot)]; }
    const TileMarks& marks() const { return marks_; }
    const std::vector<int>& order() const { return order_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void refresh();
    void arrange();
    void step(int robot, int key, Qt::KeyboardModifiers modifiers);
    void chooseAll();
    void showTip(int robot);

    RobotChoice& choice_;
    std::array<RobotTile*, thunderbots::kRobots> tiles_{};
    std::array<thunderbots::RobotState, thunderbots::kRobots> states_{};
    TileMarks marks_;
    TimePoint now_{};
    std::vector<int> order_;
};

}  // namespace kickstand::ui
