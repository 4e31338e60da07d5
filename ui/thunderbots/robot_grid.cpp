#include "ui/thunderbots/robot_grid.h"

#include <QKeyEvent>
#include <algorithm>
#include <numeric>

#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/robot_tile.h"
#include "ui/thunderbots/tile_layout.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kColumns = 2;
constexpr int kRows = kRobots / kColumns;
constexpr int kTileGap = 4;

/// The place that a key leads to; it may lie outside.
int neighbour(int place, int key) {
    switch (key) {
        case Qt::Key_Left:
            return place - 1;
        case Qt::Key_Right:
            return place + 1;
        case Qt::Key_Up:
            return place - kColumns;
        case Qt::Key_Down:
            return place + kColumns;
        case Qt::Key_Home:
            return 0;
        default:
            return kRobots - 1;
    }
}

}  // namespace

RobotGrid::RobotGrid(RobotChoice& choice, QWidget* parent)
    : QWidget(parent), choice_(choice), order_(kRobots) {
    std::iota(order_.begin(), order_.end(), 0);
    for (int robot = 0; robot < kRobots; ++robot) {
        auto* tile = new RobotTile(robot, this);
        tiles_[static_cast<std::size_t>(robot)] = tile;
        connect(tile, &RobotTile::picked, this, [this](int picked, Qt::KeyboardModifiers modifiers) {
            choice_.pick(picked, modifiers, order_);
        });
        connect(tile, &RobotTile::stepped, this, &RobotGrid::step);
        connect(tile, &RobotTile::tipWanted, this, &RobotGrid::showTip);
    }
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&choice_, &RobotChoice::changed, this, &RobotGrid::refresh);
    refresh();
}

void RobotGrid::showState(const Snapshot& snapshot, TimePoint now) {
    states_ = snapshot.robots;
    now_ = now;
    marks_ = tileMarks(snapshot, marks_.lowestBattery);
    refresh();
    const auto unheard = [this](int robot) {
        const RobotState& state = states_[static_cast<std::size_t>(robot)];
        return !state.live && !state.feedback.has_value();
    };
    std::vector<int> order(kRobots);
    std::iota(order.begin(), order.end(), 0);
    std::stable_partition(order.begin(), order.end(), [&unheard](int robot) { return !unheard(robot); });
    if (order == order_ || underMouse()) return;
    order_ = std::move(order);
    arrange();
}

void RobotGrid::refresh() {
    for (int robot = 0; robot < kRobots; ++robot) {
        const RobotState& state = states_[static_cast<std::size_t>(robot)];
        tile(robot)->setContent(tileContent(robot, state, choice_.isChosen(robot), now_, marks_));
    }
}

QSize RobotGrid::sizeHint() const {
    return {kColumns * kLeastTileWidth + kTileGap, kRows * RobotTile::kMostHeight + (kRows - 1) * kTileGap};
}

QSize RobotGrid::minimumSizeHint() const {
    return {kColumns * kLeastTileWidth + kTileGap, kRows * RobotTile::kLeastHeight + (kRows - 1) * kTileGap};
}

void RobotGrid::arrange() {
    const int tileWidth = (width() - (kColumns - 1) * kTileGap) / kColumns;
    const int room = (height() - (kRows - 1) * kTileGap) / kRows;
    const int tileHeight = std::clamp(room, RobotTile::kLeastHeight, RobotTile::kMostHeight);
    QWidget* before = nullptr;
    for (int place = 0; place < kRobots; ++place) {
        RobotTile* tile = this->tile(order_[static_cast<std::size_t>(place)]);
        tile->setGeometry(place % kColumns * (tileWidth + kTileGap),
                          place / kColumns * (tileHeight + kTileGap), tileWidth, tileHeight);
        if (before != nullptr) setTabOrder(before, tile);
        before = tile;
    }
}

void RobotGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void RobotGrid::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::SelectAll)) {
        chooseAll();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void RobotGrid::chooseAll() {
    RobotMask heard = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (states_[static_cast<std::size_t>(robot)].live) heard |= maskOf(robot);
    }
    choice_.choose(heard == 0 ? kAllRobots : heard);
}

void RobotGrid::step(int robot, int key, Qt::KeyboardModifiers modifiers) {
    const auto at = static_cast<int>(std::find(order_.begin(), order_.end(), robot) - order_.begin());
    const int to = neighbour(at, key);
    if (to < 0 || to >= kRobots) return;
    const int next = order_[static_cast<std::size_t>(to)];
    tile(next)->setFocus(Qt::TabFocusReason);
    if (modifiers.testFlag(Qt::ShiftModifier)) choice_.pick(next, Qt::ShiftModifier, order_);
}

void RobotGrid::showTip(int robot) {
    tile(robot)->setToolTip(readingsTip(robot, states_[static_cast<std::size_t>(robot)], now_, marks_));
}

}  // namespace kickstand::ui
