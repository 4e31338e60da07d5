// Safety 1: STOP.

#include "tests/session/safety_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;

class Stop : public SafetyTest {};

TEST_F(Stop, IsALatchCheckedAtEverySubmission) {
    drive(0);
    // Latched by another thread, which the engine has not come to notice: what it submits is braked all the
    // same.
    rig.flows().stop.set(StopReason::Person);
    rig.forgetPackets();
    rig.give(SetWheels{maskOf(1), {50, 50, 50, 50}});
    rig.give(SetDribbler{maskOf(2), true});
    rig.advance(1s);
    ASSERT_FALSE(blocksIn(rig.packets()).empty());
    for (const SentBlock& sent : blocksIn(rig.packets()))
        EXPECT_EQ(sent.block, wire::brakedBlock()) << "robot " << sent.robot;
}

TEST_F(Stop, CancelsUnsentKicks) {
    charge(0);
    // The dongle has six buffers, and a robot that is not heard any more empties none of them.
    rig.simulate("loss", 1);
    for (int i = 0; i < 8; ++i)
        rig.give(SetTestMode{maskOf(0), {wire::TestClass::Lamp, 0}});
    rig.advance(20ms);
    rig.forgetPackets();
    const CommandId kick = rig.give(Kick{0, kKick});
    rig.advance(20ms);
    ASSERT_EQ(rig.answers(kick), 0U) << "it waits";
    rig.stop();
    rig.advance(20ms);
    ASSERT_EQ(rig.answers(kick), 1U);
    EXPECT_EQ(rig.answer(kick)->error().code, Errc::StopLatched);
    rig.simulate("loss", 0);
    rig.rearm();
    rig.advance(5s);
    EXPECT_EQ(kicksIn(rig.packets()), 0U);
    EXPECT_EQ(rig.robot(0).kicks, 0U);
}

TEST_F(Stop, BrakesEveryRobot) {
    drive(0);
    drive(3);
    rig.forgetPackets();
    rig.stop();
    rig.advance(10ms);
    EXPECT_EQ(brakedRobots(), kAllRobots);
    rig.advance(500ms);
    EXPECT_FALSE(rig.anyWheelTurns());
    EXPECT_EQ(latched(), StopReason::Person);
}

TEST_F(Stop, DropsDribblerChargerAndAutokick) {
    ASSERT_TRUE(rig.arm(1));
    ASSERT_TRUE(rig.ask(SetDribbler{maskOf(1), true}));
    ASSERT_TRUE(rig.ask(SetCharger{maskOf(1), true}));
    ASSERT_TRUE(rig.ask(SetAutokick{maskOf(1), true, kKick}));
    rig.advance(500ms);
    ASSERT_TRUE(rig.robot(1).charging);
    ASSERT_TRUE(rig.robot(1).dribbling);
    ASSERT_TRUE(rig.robot(1).lastDrive.autokickArmed);
    rig.stop();
    rig.advance(500ms);
    EXPECT_FALSE(rig.robot(1).charging);
    EXPECT_FALSE(rig.robot(1).dribbling);
    EXPECT_EQ(rig.robot(1).lastDrive, wire::brakedBlock());
    EXPECT_FALSE(intent(1).highVoltageArmed) << "on screen it is disarmed too";
    rig.simulate("ball", 1, 1);
    rig.advance(1s);
    EXPECT_EQ(rig.robot(1).kicks, 0U);
}

TEST_F(Stop, EndsADischarge) {
    charge(0);
    ASSERT_TRUE(rig.ask(Discharge{0, true}));
    rig.advance(500ms);
    rig.stop();
    rig.advance(500ms);
    const auto kicks = rig.robot(0).kicks;
    rig.advance(2s);
    EXPECT_EQ(rig.robot(0).kicks, kicks);
    ASSERT_TRUE(rig.last(EventKind::DischargeEnded));
    EXPECT_EQ(rig.last(EventKind::DischargeEnded)->code, static_cast<std::int64_t>(Errc::StopLatched));
}

TEST_F(Stop, StaysUntilReArmedByASeparateAct) {
    drive(0);
    rig.stop();
    rig.advance(10ms);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {10, 10, 10, 10}}), Errc::StopLatched);
    EXPECT_EQ(rig.refusal(SetDribbler{maskOf(0), true}), Errc::StopLatched);
    EXPECT_EQ(rig.refusal(ArmHighVoltage{maskOf(0), true}), Errc::StopLatched);
    EXPECT_EQ(rig.refusal(Kick{0, kKick}), Errc::StopLatched);
    EXPECT_EQ(rig.refusal(SetTestMode{maskOf(0), {wire::TestClass::Lamp, 0}, TestModeWay::DriveBlock}),
              Errc::StopLatched);
    rig.advance(1h);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {10, 10, 10, 10}}), Errc::StopLatched);
    rig.rearm();
    rig.advance(100ms);
    EXPECT_FALSE(rig.anyWheelTurns()) << "re-arming starts nothing";
    EXPECT_FALSE(driven(0));
    drive(0);
}

TEST_F(Stop, SwitchingThingsOffWorksWhileLatched) {
    rig.stop();
    rig.advance(10ms);
    EXPECT_FALSE(rig.refusal(Brake{kAllRobots}));
    EXPECT_FALSE(rig.refusal(SetDribbler{maskOf(0), false}));
    EXPECT_FALSE(rig.refusal(SetCharger{maskOf(0), false}));
    EXPECT_FALSE(rig.refusal(ArmHighVoltage{maskOf(0), false}));
}

TEST_F(Stop, HoldsEvenWhenItIsReArmedBeforeTheEngineLooked) {
    drive(0);
    rig.flows().stop.set(StopReason::Person);
    rig.flows().stop.rearm();
    rig.advance(500ms);
    EXPECT_FALSE(rig.anyWheelTurns());
    EXPECT_FALSE(driven(0));
}

TEST_F(Stop, BrakesAllWhenItIsPressedAgain) {
    rig.stop();
    rig.rearm();
    rig.advance(10ms);
    drive(0);
    rig.stop();
    rig.advance(500ms);
    EXPECT_FALSE(rig.anyWheelTurns());
}

TEST_F(Stop, IsSentAgainWhenItIsPressedWhileItIsLatched) {
    rig.stop();
    rig.advance(100ms);
    rig.forgetPackets();
    rig.stop();
    rig.advance(100ms);
    EXPECT_EQ(brakedRobots(), kAllRobots);
}

TEST_F(Stop, ALinkThatIsGivenUpBrakesFirst) {
    drive(0);
    // The debug text stalls once more often than is tried again; the way out still works.
    rig.waitUntil([this] {
        if (rig.state().link == LinkState::Running)
            rig.simulate("stall", wire::address(wire::Endpoint::DebugText));
        return rig.state().link == LinkState::Failed;
    });
    ASSERT_EQ(rig.state().link, LinkState::Failed);
    EXPECT_EQ(latched(), StopReason::LinkLost);
    rig.advance(100ms);
    EXPECT_FALSE(rig.robot(0).lastDrive.run) << "told, not left to the dongle's dead-man";
}

TEST_F(Stop, TheEmergencyStopLeavingRunLatchesIt) {
    for (const auto position : {wire::EStop::Stop, wire::EStop::Disconnected, wire::EStop::Uninitialized}) {
        drive(0);
        rig.simulate("e-stop", static_cast<double>(position));
        rig.advance(500ms);
        EXPECT_EQ(latched(), StopReason::EmergencyStop);
        rig.simulate("e-stop", static_cast<double>(wire::EStop::Run));
        rig.advance(500ms);
        EXPECT_FALSE(driven(0)) << "what was set before it does not come back";
        EXPECT_EQ(latched(), StopReason::EmergencyStop);
        rig.rearm();
        rig.advance(20ms);
    }
}

TEST_F(Stop, NothingMovesWhileTheEmergencyStopIsNotInRun) {
    rig.simulate("e-stop", static_cast<double>(wire::EStop::Stop));
    rig.advance(100ms);
    rig.rearm();
    rig.advance(20ms);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {10, 10, 10, 10}}), Errc::EmergencyStopNotRun);
    EXPECT_EQ(rig.refusal(Kick{0, kKick}), Errc::EmergencyStopNotRun);
}

TEST_F(Stop, ARobotThatIsLostWhileSomethingMovesLatchesIt) {
    drive(0);
    drive(1);
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::RobotLost) == 1; }, 60s));
    EXPECT_EQ(latched(), StopReason::RobotLost);
    rig.advance(500ms);
    EXPECT_FALSE(rig.anyWheelTurns());
}

TEST_F(Stop, ARobotThatIsLostWhileAllIsQuietLatchesNothing) {
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::RobotLost) == 1; }, 60s));
    EXPECT_EQ(latched(), StopReason::None);
}

TEST_F(Stop, ALostLinkLatchesIt) {
    drive(0);
    rig.simulate("plugged", 0);
    rig.advance(20ms);
    EXPECT_EQ(latched(), StopReason::LinkLost);
    EXPECT_EQ(rig.count(EventKind::LinkLost), 1U);
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::Connected) == 2; }, 20s));
    EXPECT_EQ(latched(), StopReason::LinkLost) << "a new connection re-arms nothing";
}

TEST_F(Stop, WorksInEveryStateOfTheLink) {
    rig.simulate("plugged", 0);
    rig.advance(20ms);
    rig.rearm();
    rig.stop();
    rig.advance(20ms);
    EXPECT_EQ(latched(), StopReason::Person) << "with no device";
    rig.simulate("plugged", 1);
    std::vector<LinkState> seen;
    for (int i = 0; i < 2000 && rig.state().link != LinkState::Running; ++i) {
        if (seen.empty() || seen.back() != rig.state().link) seen.push_back(rig.state().link);
        rig.rearm();
        rig.stop();
        rig.advance(1ms);
        ASSERT_EQ(latched(), StopReason::Person) << name(rig.state().link);
    }
    EXPECT_EQ(rig.state().link, LinkState::Running) << "it does not keep the link from starting";
    EXPECT_GE(seen.size(), 2U);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {1, 1, 1, 1}}), Errc::StopLatched);
}

TEST_F(Stop, ReachesEverySessionWithinAStep) {
    // A session that latches it, for a link that it lost, halts the others through the engine.
    drive(0);
    rig.forgetPackets();
    rig.flows().stop.set(StopReason::LinkLost);
    rig.advance(15ms);
    EXPECT_EQ(brakedRobots(), kAllRobots);
}

TEST_F(Stop, LeavesNothingForAReconnectionToReplay) {
    charge(0);
    drive(1);
    const CommandId kick = rig.give(Kick{0, kKick});
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    ASSERT_EQ(rig.answers(kick), 1U);
    rig.rearm();
    rig.forgetPackets();
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::Connected) == 2; }, 20s));
    rig.advance(5s);
    for (const SentBlock& sent : blocksIn(rig.packets()))
        EXPECT_EQ(sent.block, wire::brakedBlock());
    EXPECT_EQ(kicksIn(rig.packets()), 0U);
    EXPECT_EQ(rig.robot(0).kicks, 0U);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
