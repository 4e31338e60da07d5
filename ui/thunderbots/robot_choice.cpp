#include "ui/thunderbots/robot_choice.h"

#include <algorithm>

namespace kickstand::ui {

using namespace thunderbots;

void RobotChoice::choose(RobotMask robots) {
    if (robots == chosen_) return;
    chosen_ = robots;
    emit changed();
}

void RobotChoice::pick(int robot, Qt::KeyboardModifiers modifiers, const std::vector<int>& order) {
    const auto from = std::find(order.begin(), order.end(), anchor_);
    const auto to = std::find(order.begin(), order.end(), robot);
    if (modifiers.testFlag(Qt::ShiftModifier) && from != order.end() && to != order.end()) {
        RobotMask range = modifiers.testFlag(Qt::ControlModifier) ? chosen_ : RobotMask{0};
        for (auto at = std::min(from, to); at <= std::max(from, to); ++at)
            range |= maskOf(*at);
        choose(range);
        return;
    }
    anchor_ = robot;
    choose(modifiers.testFlag(Qt::ControlModifier) ? static_cast<RobotMask>(chosen_ ^ maskOf(robot))
                                                   : maskOf(robot));
}

}  // namespace kickstand::ui
