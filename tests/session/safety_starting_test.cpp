// Safety 3: starting.

#include <set>

#include "tests/session/safety_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;

class Starting : public SafetyTest {
  protected:
    int speedOf(int robot) { return rig.robot(robot).lastDrive.wheels[0]; }
    /// The speeds that were sent to a robot's first wheel since the packets were forgotten.
    std::vector<SentBlock> sentTo(int robot) {
        std::vector<SentBlock> found;
        for (const SentBlock& sent : blocksIn(rig.packets())) {
            if (sent.robot == robot) found.push_back(sent);
        }
        return found;
    }
};

TEST_F(Starting, BrakesAllSixteenFirst) {
    const auto checkStart = [this] {
        std::set<int> braked;
        for (std::size_t i = 0; braked.size() < kRobots; ++i) {
            ASSERT_LT(i, rig.packets().size());
            ASSERT_FALSE(rig.packets()[i].bytes.empty()) << "no keep-alive before them";
            for (const SentBlock& sent : blocksIn({rig.packets()[i]})) {
                EXPECT_EQ(sent.block, wire::brakedBlock());
                braked.insert(sent.robot);
            }
        }
    };
    checkStart();
    drive(0);
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    rig.forgetPackets();
    rig.rearm();
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::Connected) == 2; }, 20s));
    checkStart();
}

TEST_F(Starting, FindsEverythingAtZeroAfterAReconnection) {
    ASSERT_TRUE(rig.arm(0));
    ASSERT_TRUE(rig.ask(SetDribbler{maskOf(0), true}));
    ASSERT_TRUE(rig.ask(SetCharger{maskOf(0), true}));
    drive(0);
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    rig.rearm();
    rig.simulate("plugged", 1);
    ASSERT_TRUE(
        rig.waitUntil([this] { return rig.isRunning() && rig.count(EventKind::Connected) == 2; }, 20s));
    const RobotIntent& now = intent(0);
    EXPECT_FALSE(now.active());
    EXPECT_FALSE(now.highVoltageArmed);
    EXPECT_EQ(now.target, WheelSpeeds{});
}

TEST_F(Starting, LimitsWheelsToAHundred) {
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {0, 0, 0, 101}}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {-101, 0, 0, 0}}), Errc::OutOfRange);
    rig.advance(1s);
    EXPECT_FALSE(rig.anyWheelTurns());
    EXPECT_FALSE(rig.refusal(SetWheels{maskOf(0), {100, -100, 100, -100}}));
}

TEST_F(Starting, RampsTwoHundredUnitsASecond) {
    rig.forgetPackets();
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(0), {100, -100, 50, 0}}));
    rig.advance(1s);
    const auto sent = sentTo(0);
    ASSERT_GT(sent.size(), 20U);
    for (const SentBlock& one : sent) {
        const double allowed = 200 * seconds(one.time - sent.front().time) + 200 * 0.012;
        EXPECT_LE(one.block.wheels[0], allowed);
        EXPECT_GE(one.block.wheels[1], -allowed);
    }
    EXPECT_EQ(sent.back().block.wheels, (std::array<std::int16_t, 4>{100, -100, 50, 0}));
    EXPECT_GE(sent.back().time - sent.front().time, 480ms);
}

TEST_F(Starting, RampsAnewAfterALongTimeAtASteadySpeed) {
    drive(0, 20);
    rig.advance(10s);
    rig.forgetPackets();
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(0), {100, 100, 100, 100}}));
    rig.advance(100ms);
    for (const SentBlock& one : sentTo(0))
        EXPECT_LE(one.block.wheels[0], 20 + 22);
}

TEST_F(Starting, NeverRampsBraking) {
    drive(0);
    rig.advance(1s);
    rig.forgetPackets();
    ASSERT_TRUE(rig.ask(Brake{maskOf(0)}));
    rig.advance(10ms);
    ASSERT_FALSE(sentTo(0).empty());
    EXPECT_FALSE(sentTo(0).front().block.run);
    drive(0);
    rig.advance(1s);
    rig.forgetPackets();
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(0), {0, 0, 0, 0}}));
    rig.advance(10ms);
    ASSERT_FALSE(sentTo(0).empty());
    EXPECT_EQ(sentTo(0).front().block.wheels[0], 0);
}

TEST_F(Starting, APersonRaisesTheLimitForThisConnectionOnly) {
    EXPECT_EQ(rig.refusal(SetWheelLimit{1024}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(SetWheelLimit{-1}), Errc::OutOfRange);
    ASSERT_TRUE(rig.ask(SetWheelLimit{800}));
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(0), {800, 800, 800, 800}}));
    rig.advance(200ms);
    EXPECT_EQ(speedOf(0), 800) << "without a ramp";
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {801, 0, 0, 0}}), Errc::OutOfRange);
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    rig.rearm();
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::Connected) == 2; }, 20s));
    ASSERT_TRUE(rig.waitUntil([this] { return rig.isRunning(); }, 20s));
    EXPECT_EQ(rig.state().wheelLimit, kStartingWheelLimit);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {101, 0, 0, 0}}), Errc::OutOfRange);
}

TEST_F(Starting, LoweringTheLimitSlowsWhatRunsFaster) {
    ASSERT_TRUE(rig.ask(SetWheelLimit{800}));
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(0), {800, -800, 800, 50}}));
    rig.advance(200ms);
    ASSERT_TRUE(rig.ask(SetWheelLimit{100}));
    rig.advance(200ms);
    EXPECT_EQ(rig.robot(0).lastDrive.wheels, (std::array<std::int16_t, 4>{100, -100, 100, 50}));
}

TEST_F(Starting, AHeldInputMustPassZeroBeforeItCounts) {
    const SetWheels pressed{maskOf(0), {30, 30, 30, 30}, true};
    const SetWheels released{maskOf(0), {0, 0, 0, 0}, true};
    const auto mustPassZero = [&](const char* when) {
        EXPECT_EQ(rig.refusal(pressed), Errc::MustPassZero) << when;
        EXPECT_FALSE(rig.refusal(released)) << when;
        EXPECT_FALSE(rig.refusal(pressed)) << when;
    };
    mustPassZero("after connecting");
    rig.stop();
    rig.advance(20ms);
    EXPECT_EQ(rig.refusal(pressed), Errc::StopLatched);
    rig.rearm();
    rig.advance(20ms);
    mustPassZero("after STOP");
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    rig.rearm();
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::Connected) == 2; }, 20s));
    ASSERT_TRUE(rig.waitUntil([this] { return rig.isRunning(); }, 20s));
    mustPassZero("after a reconnection");
}

TEST_F(Starting, AHeldInputThatWasPressedWhileItMightNotMustBeLetGo) {
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(0), {0, 0, 0, 0}, true}));
    rig.simulate("e-stop", static_cast<double>(wire::EStop::Stop));
    rig.advance(100ms);
    rig.rearm();
    rig.advance(20ms);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {30, 30, 30, 30}, true}), Errc::EmergencyStopNotRun);
    rig.simulate("e-stop", static_cast<double>(wire::EStop::Run));
    rig.advance(100ms);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {30, 30, 30, 30}, true}), Errc::MustPassZero);
}

TEST_F(Starting, ARobotThatWasLostComesBackBraked) {
    drive(0);
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::RobotLost) == 1; }, 60s));
    rig.rearm();
    const std::size_t found = rig.count(EventKind::RobotFound);
    rig.simulate("dead", 0, 0);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::RobotFound) > found; }, 60s));
    rig.advance(2s);
    EXPECT_EQ(rig.robot(0).lastDrive, wire::brakedBlock());
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {30, 30, 30, 30}, true}), Errc::MustPassZero);
}

TEST_F(Starting, NewChannelsBrakeEverythingFirstAndStartAfresh) {
    drive(0);
    rig.forgetPackets();
    const CommandId set = rig.give(SetChannels{0x0B, 0x1A});
    const CommandId tooLate = rig.give(SetWheels{maskOf(0), {50, 50, 50, 50}});
    const CommandId another = rig.give(SetChannels{0x0C, 0x0D});
    rig.advance(20s);
    EXPECT_EQ(rig.answers(set), 1U);
    EXPECT_TRUE(*rig.answer(set));
    ASSERT_EQ(rig.answers(tooLate), 1U);
    EXPECT_EQ(rig.answer(tooLate)->error().code, Errc::NotConnected);
    ASSERT_EQ(rig.answers(another), 1U);
    EXPECT_EQ(rig.answer(another)->error().code, Errc::NotConnected);
    EXPECT_EQ(rig.state().link, LinkState::Running);
    EXPECT_EQ(rig.state().channels, (wire::Channels{0x0B, 0x1A}));
    for (const SentBlock& sent : blocksIn(rig.packets()))
        EXPECT_EQ(sent.block, wire::brakedBlock());
    EXPECT_EQ(rig.refusal(SetChannels{0x0A, 0x1A}), Errc::OutOfRange);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
