#include "ui/thunderbots/tile_marks.h"

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

using namespace thunderbots;

class TileMarksTest : public testing::Test {
  protected:
    TileMarksTest() {
        for (int robot = 0; robot < 5; ++robot) {
            state(robot).live = true;
            state(robot).freshness = Freshness::Current;
            state(robot).readings.battery_V = 16 + 0.1 * robot;
            state(robot).told = wire::brakedBlock();
        }
    }
    RobotState& state(int robot) { return snapshot.robots[static_cast<std::size_t>(robot)]; }

    Snapshot snapshot;
};

TEST_F(TileMarksTest, TheLowestBatteryIsMarked) {
    EXPECT_EQ(tileMarks(snapshot, -1).lowestBattery, 0);
    state(3).readings.battery_V = 14;
    EXPECT_EQ(tileMarks(snapshot, 0).lowestBattery, 3);
}

TEST_F(TileMarksTest, NoiseMovesNoMark) {
    state(1).readings.battery_V = 15.95;
    EXPECT_EQ(tileMarks(snapshot, 0).lowestBattery, 0);
    EXPECT_EQ(tileMarks(snapshot, -1).lowestBattery, 1);
}

TEST_F(TileMarksTest, OneThatIsLostGivesItsMarkAway) {
    state(0).freshness = Freshness::Stale;
    EXPECT_EQ(tileMarks(snapshot, 0).lowestBattery, 1);
}

TEST_F(TileMarksTest, AloneThereIsNoLowest) {
    for (int robot = 1; robot < 5; ++robot)
        state(robot).freshness = Freshness::NotHeard;
    EXPECT_EQ(tileMarks(snapshot, -1).lowestBattery, -1);
}

TEST_F(TileMarksTest, TheOneThatIsNotAsTheOthersIsNamedWithWhat) {
    EXPECT_EQ(tileMarks(snapshot, -1).oddOne, -1);
    state(2).told->charge = true;
    EXPECT_EQ(tileMarks(snapshot, -1).oddOne, 2);
    EXPECT_EQ(tileMarks(snapshot, -1).oddBy, QStringLiteral("charging"));
    state(3).told->charge = true;
    EXPECT_EQ(tileMarks(snapshot, -1).oddOne, -1);
    for (const int robot : {0, 1, 2, 3})
        state(robot).told->run = true;
    EXPECT_EQ(tileMarks(snapshot, -1).oddOne, 4);
    EXPECT_EQ(tileMarks(snapshot, -1).oddBy, QStringLiteral("braked"));
}

TEST_F(TileMarksTest, OfTwoNeitherIsOdd) {
    for (int robot = 2; robot < 5; ++robot)
        state(robot).live = false;
    state(0).told->charge = true;
    EXPECT_EQ(tileMarks(snapshot, -1).oddOne, -1);
}

}  // namespace
}  // namespace kickstand::ui
