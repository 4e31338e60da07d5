// Closing the window.

#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/robot_tile.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using wire::DriveBlock;

class CloseTest : public BenchTest {
  protected:
    QMessageBox* warning() { return rig.window().findChild<QMessageBox*>(QStringLiteral("liveWarning")); }
    void chargeRobot3() {
        rig.simulate("capacitor", 3, 212);
        ASSERT_TRUE(
            rig.waitForSnapshot([](const Snapshot& s) { return s.robots[3].readings.capacitor_V > 200; }));
    }
};

TEST_F(CloseTest, WithNothingLiveTheWindowClosesWithoutAQuestion) {
    ASSERT_TRUE(rig.settle());
    rig.window().close();
    EXPECT_FALSE(rig.window().isVisible());
    EXPECT_EQ(warning(), nullptr);
}

TEST_F(CloseTest, ClosingBrakesAtOnce) {
    rig.clickRobot(3);
    rig.typeWheel(1, QStringLiteral("30"));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 30; }));
    rig.window().close();
    EXPECT_TRUE(rig.client().isStopped());
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
}

TEST_F(CloseTest, LiveCapacitorsAreAskedAboutAfterEverythingIsBraked) {
    chargeRobot3();
    rig.window().close();
    ASSERT_NE(warning(), nullptr);
    EXPECT_TRUE(rig.client().isStopped());
    EXPECT_TRUE(rig.window().isVisible());
    EXPECT_TRUE(warning()->informativeText().contains(QStringLiteral("robot 3")));
    EXPECT_TRUE(warning()->informativeText().contains(QStringLiteral("212")));
    QTest::mouseClick(warning()->findChild<QPushButton*>(QStringLiteral("stay")), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([this] { return warning() == nullptr; }));
    EXPECT_TRUE(rig.window().isVisible());
}

TEST_F(CloseTest, LeavingThemLiveClosesTheWindow) {
    chargeRobot3();
    rig.window().close();
    ASSERT_NE(warning(), nullptr);
    QTest::mouseClick(warning()->findChild<QPushButton*>(QStringLiteral("leave")), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([this] { return !rig.window().isVisible(); }));
}

TEST_F(CloseTest, ACapacitorLastSeenLiveCountsToo) {
    chargeRobot3();
    rig.simulate("dead", 3, 1);
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) { return !snapshot.robots[3].live; }));
    rig.window().close();
    ASSERT_NE(warning(), nullptr);
    EXPECT_TRUE(warning()->informativeText().contains(QStringLiteral("treat as live")));
}

TEST_F(CloseTest, AskingTwiceShowsOneQuestion) {
    chargeRobot3();
    rig.window().close();
    rig.window().close();
    EXPECT_EQ(rig.window().findChildren<QMessageBox*>(QStringLiteral("liveWarning")).size(), 1);
}

TEST_F(CloseTest, ASignalClosesWithoutAQuestion) {
    chargeRobot3();
    rig.window().closeNow();
    EXPECT_EQ(warning(), nullptr);
    EXPECT_FALSE(rig.window().isVisible());
    EXPECT_TRUE(rig.client().isStopped());
}

}  // namespace
}  // namespace kickstand::test
