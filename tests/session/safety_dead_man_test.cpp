// Safety 2: the dead-man. Bounds are measured on the fake clock at the simulated wheels.

#include "core/thunderbots/sim/robot_report.h"
#include "tests/session/safety_testing.h"
#include "tests/support/session/faulty_usb_link.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;

/// How long the machine of a test has slept; there before the engine that asks for it.
struct Sleep {
    Duration asleep{};
};

class DeadMan : protected Sleep, public SafetyTest {
  protected:
    /// All sixteen: the more robots share the radio, the longer each waits for its block.
    static kickstand::testing::SessionRigOptions allRobots() {
        auto made = options();
        made.sim.robots = kAllRobots;
        return made;
    }
    explicit DeadMan(kickstand::testing::SessionRigOptions made = allRobots())
        : SafetyTest(withSleep(std::move(made))) {}

    kickstand::testing::SessionRigOptions withSleep(kickstand::testing::SessionRigOptions made) {
        made.engine.timeAsleep = [this] { return asleep; };
        return made;
    }

    /// Time until no robot is driven any more; a minute when that never happens.
    Duration untilBraked() {
        const TimePoint from = rig.scheduler().now();
        for (Duration waited{}; waited < 1min; waited += 1ms) {
            bool any = false;
            for (int robot = 0; robot < kRobots; ++robot)
                any = any || driven(robot);
            if (!any) break;
            rig.advance(1ms);
        }
        return rig.scheduler().now() - from;
    }
};

TEST_F(DeadMan, AFrozenWindowBrakesWithinSixTenthsOfASecond) {
    for (int robot = 0; robot < kRobots; ++robot)
        drive(robot);
    rig.flows().heartbeat.beat(rig.scheduler().now());
    rig.beat(false);
    const Duration braked = untilBraked();
    EXPECT_LE(braked, 600ms);
    EXPECT_GE(braked, 390ms) << "a sign of life holds for a while";
    EXPECT_EQ(latched(), StopReason::HeartbeatStale);
    rig.advance(1s);
    EXPECT_FALSE(rig.anyWheelTurns());
}

TEST_F(DeadMan, AFrozenWindowOnALossyRadioBrakesToo) {
    rig.simulate("loss", 0.3);
    drive(0);
    drive(1);
    rig.beat(false);
    EXPECT_LE(untilBraked(), 1100ms) << "at the latest by the robot's own time-out";
}

TEST_F(DeadMan, AProgramThatWasStoppedForAWhileDoesNotGoOnWhereItWas) {
    drive(0);
    rig.scheduler().stall(3s);
    // Whoever drives is woken first and says at once that all is well.
    rig.flows().heartbeat.beat(rig.scheduler().now());
    rig.advance(100ms);
    EXPECT_EQ(latched(), StopReason::HeartbeatStale);
    EXPECT_FALSE(driven(0));
}

TEST_F(DeadMan, AMachineThatSleptDoesNotGoOnWhereItWas) {
    drive(0);
    asleep = 10min;
    rig.advance(100ms);
    EXPECT_EQ(latched(), StopReason::Suspend);
    EXPECT_FALSE(driven(0));
}

TEST_F(DeadMan, AnIdleProgramMaySleepWithoutBeingStopped) {
    asleep = 10min;
    rig.advance(100ms);
    EXPECT_EQ(latched(), StopReason::None);
    drive(0);
    EXPECT_TRUE(driven(0));
}

TEST_F(DeadMan, ALinkThatTakesNothingForAsLongAsTheDonglesDeadManStops) {
    kickstand::testing::FaultyUsbLink* faulty = nullptr;
    auto made = options();
    made.decorate = [&faulty](std::unique_ptr<UsbLink> link, Scheduler& scheduler) {
        auto around = std::make_unique<kickstand::testing::FaultyUsbLink>(std::move(link), scheduler,
                                                                          kickstand::testing::FaultPlan{});
        faulty = around.get();
        return around;
    };
    kickstand::testing::SessionRig blocked(std::move(made));
    ASSERT_TRUE(blocked.connect());
    ASSERT_TRUE(blocked.ask(SetWheels{maskOf(0), {50, 50, 50, 50}}));
    blocked.advance(1s);
    faulty->refuseOut();
    blocked.advance(1400ms);
    EXPECT_EQ(blocked.flows().stop.reason(), StopReason::None);
    blocked.advance(700ms);
    EXPECT_EQ(blocked.flows().stop.reason(), StopReason::LinkLost)
        << "the dongle has braked: what is wanted is not what is done";
}

TEST_F(DeadMan, NobodyMovesWithoutASignOfLife) {
    rig.beat(false);
    rig.advance(500ms);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {10, 10, 10, 10}}), Errc::HeartbeatStale);
    EXPECT_EQ(rig.refusal(SetDribbler{maskOf(0), true}), Errc::HeartbeatStale);
    EXPECT_EQ(rig.refusal(ArmHighVoltage{maskOf(0), true}), Errc::HeartbeatStale);
    EXPECT_EQ(latched(), StopReason::None) << "nothing moved that had to be stopped";
}

TEST_F(DeadMan, KeepAlivesGoOnlyWhileTheSignOfLifeIsFreshAndBrakedBlocksGoFirst) {
    drive(0);
    rig.advance(2s);
    rig.forgetPackets();
    rig.advance(3s);
    EXPECT_GE(rig.packets().size(), 9U) << "keep-alives of a steady robot";
    EXPECT_TRUE(blocksIn(rig.packets()).empty());
    rig.beat(false);
    rig.advance(420ms);
    rig.forgetPackets();
    rig.advance(10s);
    EXPECT_TRUE(rig.packets().empty()) << "silence: the dongle's own dead-man takes over";
    EXPECT_FALSE(rig.anyWheelTurns());
}

TEST_F(DeadMan, ASignOfLifeThatComesBackStartsNothing) {
    drive(0);
    rig.beat(false);
    rig.advance(1s);
    rig.beat(true);
    rig.advance(5s);
    EXPECT_FALSE(rig.anyWheelTurns());
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {10, 10, 10, 10}}), Errc::StopLatched);
}

TEST_F(DeadMan, AKilledProgramBrakesWithinTwoPointTwoSeconds) {
    for (int robot = 0; robot < kRobots; ++robot)
        drive(robot);
    rig.killHost();
    const Duration braked = untilBraked();
    EXPECT_LE(braked, 2200ms);
    EXPECT_GE(braked, 1s) << "the dongle goes on for a while by itself";
}

TEST_F(DeadMan, AnUnpluggedDongleBrakesWithinOnePointOneSeconds) {
    for (int robot = 0; robot < kRobots; ++robot)
        drive(robot);
    rig.simulate("plugged", 0);
    EXPECT_LE(untilBraked(), 1100ms);
}

TEST_F(DeadMan, ClosingASessionBrakesAtOnce) {
    drive(0);
    drive(2);
    const CommandId disconnect = rig.give(Disconnect{}, 1);
    EXPECT_LE(untilBraked(), 200ms);
    EXPECT_EQ(rig.answers(disconnect), 1U);
}

TEST_F(DeadMan, EndingTheProgramBrakesAtOnce) {
    drive(0);
    drive(2);
    bool done = false;
    rig.core().shutdown([&done] { done = true; });
    EXPECT_LE(untilBraked(), 200ms);
    EXPECT_TRUE(done);
}

class CableDeadMan : public DeadMan {
  protected:
    static kickstand::testing::SessionRigOptions cable() {
        auto made = options();
        made.sim.cableRobot = 2;
        return made;
    }
    CableDeadMan() : DeadMan(cable()) {}
};

TEST_F(CableDeadMan, AFrozenWindowBrakesWithinSixTenthsOfASecond) {
    drive(2);
    rig.beat(false);
    EXPECT_LE(untilBraked(), 600ms);
}

TEST_F(CableDeadMan, AKilledProgramBrakesWithinOnePointOneSeconds) {
    drive(2);
    rig.killHost();
    EXPECT_LE(untilBraked(), 1100ms);
}

TEST_F(CableDeadMan, AnUnpluggedCableBrakesWithinOnePointOneSeconds) {
    drive(2);
    rig.simulate("plugged", 0);
    EXPECT_LE(untilBraked(), 1100ms);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
