// Arming, charging and discharging, to the bytes on the wire.

#include <QAbstractButton>

#include "core/thunderbots/wire/readings.h"
#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/capacitor_readout.h"
#include "ui/thunderbots/robot_tile.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using wire::DriveBlock;

class VoltageTest : public BenchTest {
  protected:
    bool armAndCharge(int robot) {
        rig.clickRobot(robot);
        rig.click(QStringLiteral("arm"));
        if (!waitUntil([this] { return button("charger")->isEnabled(); })) return false;
        rig.click(QStringLiteral("charger"));
        return rig.waitForBlock(robot, [](const DriveBlock& block) { return block.charge; });
    }
    QAbstractButton* button(const char* name) { return rig.find<QAbstractButton>(QLatin1String(name)); }
    ui::RobotTile* tile(int robot) { return rig.find<ui::RobotTile>(QStringLiteral("robot%1").arg(robot)); }
};

TEST_F(VoltageTest, TheChargerNeedsTheHighVoltageArmed) {
    rig.clickRobot(3);
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(button("arm")->isEnabled());
    EXPECT_FALSE(button("charger")->isEnabled());
    EXPECT_FALSE(button("discharge")->isEnabled());
}

TEST_F(VoltageTest, ChargingIsSwitchedOnAndOffOnTheWire) {
    ASSERT_TRUE(armAndCharge(3));
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(button("charger")->isChecked());
    rig.click(QStringLiteral("charger"));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.charge; }));
}

TEST_F(VoltageTest, DisarmingSwitchesTheChargerOff) {
    ASSERT_TRUE(armAndCharge(3));
    ASSERT_TRUE(rig.settle());
    rig.click(QStringLiteral("arm"));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.charge; }));
    ASSERT_TRUE(waitUntil([this] { return !button("charger")->isEnabled(); }));
}

TEST_F(VoltageTest, ALiveCapacitorIsLoudWhereverTheRobotIsShown) {
    rig.clickRobot(3);
    rig.simulate("capacitor", 3, 120);
    ASSERT_TRUE(waitUntil([this] { return tile(3)->content().capacitorLive; }));
    EXPECT_TRUE(tile(3)->accessibleName().contains(QStringLiteral("live")));
    ASSERT_TRUE(waitUntil([this] {
        return rig.find<ui::CapacitorReadout>(QStringLiteral("capacitor"))
            ->accessibleName()
            .contains(QStringLiteral("live"));
    }));
}

TEST_F(VoltageTest, DischargingSendsKicksUntilTheCapacitorIsSafe) {
    rig.simulate("capacitor", 3, 80);
    ASSERT_TRUE(waitUntil([this] { return tile(3)->content().capacitorLive; }));
    rig.clickRobot(3);
    rig.click(QStringLiteral("arm"));
    ASSERT_TRUE(waitUntil([this] { return button("discharge")->isEnabled(); }));
    rig.click(QStringLiteral("discharge"));
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) {
        return !snapshot.intents[3].discharging &&
               snapshot.robots[3].readings.capacitor_V < wire::kCapacitorLive_V;
    }));
    EXPECT_FALSE(rig.wire().kicks().empty());
    for (const int robot : rig.wire().kicks())
        EXPECT_EQ(robot, 3);
    ASSERT_TRUE(waitUntil([this] { return !tile(3)->content().capacitorLive; }));
}

TEST_F(VoltageTest, ArmingIsForTheChosenRobotsAlone) {
    rig.clickRobot(1);
    rig.clickRobot(2, Qt::ControlModifier);
    rig.click(QStringLiteral("arm"));
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) {
        return snapshot.intents[1].highVoltageArmed && snapshot.intents[2].highVoltageArmed;
    }));
    EXPECT_FALSE(rig.snapshot()->intents[3].highVoltageArmed);
    rig.clickRobot(3);
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(button("charger")->isEnabled());
}

}  // namespace
}  // namespace kickstand::test
