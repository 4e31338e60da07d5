#include "ui/thunderbots/robot_choice.h"

#include <QSignalSpy>
#include <numeric>

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

class RobotChoiceTest : public testing::Test {
  protected:
    RobotChoiceTest() : order(thunderbots::kRobots) { std::iota(order.begin(), order.end(), 0); }

    RobotChoice choice;
    std::vector<int> order;
};

TEST_F(RobotChoiceTest, AClickChoosesOneAlone) {
    choice.pick(3, Qt::NoModifier, order);
    choice.pick(5, Qt::NoModifier, order);
    EXPECT_EQ(choice.chosen(), 0b100000);
}

TEST_F(RobotChoiceTest, CtrlAddsAndTakesAway) {
    choice.pick(3, Qt::NoModifier, order);
    choice.pick(5, Qt::ControlModifier, order);
    EXPECT_EQ(choice.chosen(), 0b101000);
    choice.pick(3, Qt::ControlModifier, order);
    EXPECT_EQ(choice.chosen(), 0b100000);
}

TEST_F(RobotChoiceTest, ShiftTakesTheRangeAsItIsShown) {
    order = {3, 8, 5, 0, 1, 2, 4, 6, 7, 9, 10, 11, 12, 13, 14, 15};
    choice.pick(5, Qt::NoModifier, order);
    choice.pick(3, Qt::ShiftModifier, order);
    EXPECT_EQ(choice.chosen(), 0b100101000);
    choice.pick(0, Qt::ShiftModifier, order);
    EXPECT_EQ(choice.chosen(), 0b100001);
}

TEST_F(RobotChoiceTest, ChoosingTheSameAgainTellsNobody) {
    choice.choose(0b1000);
    QSignalSpy changed(&choice, &RobotChoice::changed);
    choice.choose(0b1000);
    EXPECT_EQ(changed.count(), 0);
}

}  // namespace
}  // namespace kickstand::ui
