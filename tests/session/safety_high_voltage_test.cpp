// Safety 4: high voltage.

#include "core/thunderbots/wire/readings.h"
#include "tests/session/safety_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;

class HighVoltage : public SafetyTest {
  protected:
    /// Fills the dongle's buffers with messages to a robot that does not answer, so that it takes no more.
    void blockMessages() {
        rig.simulate("loss", 1);
        for (int i = 0; i < 8; ++i)
            rig.give(SetTestMode{maskOf(1), {wire::TestClass::Lamp, 0}});
        rig.advance(20ms);
    }
    double capacitor(int robot) {
        return rig.state().robots.at(static_cast<std::size_t>(robot)).capacitor->last_V;
    }
};

TEST_F(HighVoltage, KickAndChargeNeedTheRobotArmedOnScreen) {
    EXPECT_EQ(rig.refusal(Kick{0, kKick}), Errc::NotArmed);
    EXPECT_EQ(rig.refusal(SetCharger{maskOf(0), true}), Errc::NotArmed);
    EXPECT_EQ(rig.refusal(SetAutokick{maskOf(0), true, kKick}), Errc::NotArmed);
    EXPECT_EQ(rig.refusal(Discharge{0, true}), Errc::NotArmed);
    ASSERT_TRUE(rig.arm(0));
    EXPECT_FALSE(rig.refusal(Kick{0, kKick}));
    EXPECT_FALSE(rig.refusal(SetCharger{maskOf(0), true}));
    EXPECT_EQ(rig.refusal(Kick{1, kKick}), Errc::NotArmed) << "each robot by itself";
}

TEST_F(HighVoltage, KickAndChargeNeedTheRobotAlive) {
    EXPECT_EQ(rig.refusal(ArmHighVoltage{maskOf(9), true}), Errc::RobotNotAlive);
    EXPECT_EQ(rig.refusal(Kick{9, kKick}), Errc::RobotNotAlive);
    ASSERT_TRUE(rig.arm(0));
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::RobotLost) == 1; }, 60s));
    EXPECT_EQ(latched(), StopReason::RobotLost) << "it was armed";
    rig.rearm();
    EXPECT_EQ(rig.refusal(Kick{0, kKick}), Errc::RobotNotAlive);
    EXPECT_FALSE(intent(0).highVoltageArmed);
}

TEST_F(HighVoltage, AKickNamesARobotAndHasAPulse) {
    ASSERT_TRUE(rig.arm(0));
    EXPECT_EQ(rig.refusal(Kick{-1, kKick}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(Kick{16, kKick}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(Kick{0, {true, true, 0, 0, 0}}), Errc::NoEncoding);
    EXPECT_EQ(rig.refusal(Kick{0, {false, true, 5, 0, 9}}), Errc::NoEncoding)
        << "it would end before it begins";
    EXPECT_EQ(rig.refusal(Kick{0, {true, true, 200, 0, 0}}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(SetAutokick{maskOf(0), true, {}}), Errc::NoEncoding);
}

TEST_F(HighVoltage, AKickIsDeliveredOnce) {
    charge(0);
    ASSERT_TRUE(rig.ask(Kick{0, kKick}));
    rig.advance(3s);
    EXPECT_EQ(rig.robot(0).kicks, 1U);
    EXPECT_EQ(rig.state().robots[0].kicks, 1U);
    EXPECT_EQ(rig.count(EventKind::KickGiven), 1U);
}

TEST_F(HighVoltage, AKickNotSentWithinTwoHundredMillisecondsIsDropped) {
    charge(0);
    blockMessages();
    rig.forgetPackets();
    const CommandId kick = rig.give(Kick{0, kKick});
    rig.advance(195ms);
    EXPECT_EQ(rig.answers(kick), 0U);
    rig.advance(10ms);
    ASSERT_EQ(rig.answers(kick), 1U);
    EXPECT_EQ(rig.answer(kick)->error().code, Errc::KickExpired);
    EXPECT_EQ(rig.last(EventKind::KickDropped)->code, static_cast<std::int64_t>(Errc::KickExpired));
    rig.simulate("loss", 0);
    rig.advance(10s);
    EXPECT_EQ(kicksIn(rig.packets()), 0U);
    EXPECT_EQ(rig.robot(0).kicks, 0U);
}

TEST_F(HighVoltage, OneKickIsOutstandingAtATime) {
    ASSERT_TRUE(rig.arm(0));
    ASSERT_TRUE(rig.arm(1));
    const CommandId first = rig.give(Kick{0, kKick});
    const CommandId second = rig.give(Kick{1, kKick});
    rig.advance(100ms);
    EXPECT_TRUE(*rig.answer(first));
    ASSERT_EQ(rig.answers(second), 1U);
    EXPECT_EQ(rig.answer(second)->error().code, Errc::KickOutstanding);
    EXPECT_FALSE(rig.refusal(Kick{1, kKick})) << "the next may go when the first has gone";
}

TEST_F(HighVoltage, DisarmingSwitchesTheChargerAndAutokickOff) {
    ASSERT_TRUE(rig.arm(0));
    ASSERT_TRUE(rig.ask(SetCharger{maskOf(0), true}));
    ASSERT_TRUE(rig.ask(SetAutokick{maskOf(0), true, kKick}));
    rig.advance(300ms);
    ASSERT_TRUE(rig.robot(0).charging);
    ASSERT_TRUE(rig.ask(ArmHighVoltage{maskOf(0), false}));
    rig.advance(300ms);
    EXPECT_EQ(rig.robot(0).lastDrive, wire::brakedBlock());
}

TEST_F(HighVoltage, ACapacitorStaysLoudWhenItsRobotIsStaleOrLost) {
    charge(0);
    rig.advance(1s);
    const double before_V = capacitor(0);
    ASSERT_GT(before_V, 200);
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::RobotLost) == 1; }, 60s));
    const TimePoint lost = rig.scheduler().now();
    EXPECT_GT(rig.last(EventKind::RobotLost)->value, 200);
    rig.advance(40s);
    RobotState state = rig.state().robots[0];
    EXPECT_EQ(state.freshness, Freshness::Stale);
    ASSERT_TRUE(state.capacitor);
    EXPECT_NEAR(state.capacitor->last_V, before_V, 5);
    EXPECT_LE(state.capacitor->at, lost);
    rig.simulate("plugged", 0);
    rig.advance(1s);
    state = rig.state().robots[0];
    ASSERT_TRUE(state.capacitor) << "with the link lost as well";
    EXPECT_NEAR(state.capacitor->last_V, before_V, 5);
    EXPECT_LE(state.capacitor->at, lost);
}

TEST_F(HighVoltage, DischargeEmptiesTheCapacitorWithShortPulsesAndShowsHow) {
    charge(0);
    ASSERT_TRUE(rig.ask(Discharge{0, true}));
    EXPECT_TRUE(intent(0).discharging);
    EXPECT_FALSE(intent(0).charger) << "it would work against it";
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::DischargeEnded) == 1; }, 10min));
    EXPECT_EQ(rig.last(EventKind::DischargeEnded)->code, 0);
    EXPECT_LE(rig.last(EventKind::DischargeEnded)->value, 25);
    EXPECT_LE(rig.robot(0).capacitor_V, 26);
    EXPECT_FALSE(intent(0).discharging);
    ASSERT_FALSE(rig.robot(0).lastKicks.empty());
    for (const auto& kick : rig.robot(0).lastKicks) {
        EXPECT_EQ(kick.pulses[0].width_us, 96);
        EXPECT_EQ(kick.pulses[1].width_us, 0);
    }
    EXPECT_GT(rig.last(EventKind::DischargeStarted)->value, 200);
    const auto kicks = rig.robot(0).kicks;
    rig.advance(10s);
    EXPECT_LE(rig.robot(0).kicks, kicks + 1) << "it ends";
}

TEST_F(HighVoltage, DischargeIsADeliberateActThatCanBeEnded) {
    charge(0);
    ASSERT_TRUE(rig.ask(Discharge{0, true}));
    rig.advance(300ms);
    ASSERT_TRUE(rig.ask(Discharge{0, false}));
    rig.advance(1s);
    const auto kicks = rig.robot(0).kicks;
    rig.advance(3s);
    EXPECT_EQ(rig.robot(0).kicks, kicks);
    EXPECT_EQ(rig.last(EventKind::DischargeEnded)->code, static_cast<std::int64_t>(Errc::Cancelled));
}

TEST_F(HighVoltage, ALostRobotEndsItsDischarge) {
    charge(0);
    ASSERT_TRUE(rig.ask(Discharge{0, true}));
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::DischargeEnded) == 1; }, 60s));
    EXPECT_NE(rig.last(EventKind::DischargeEnded)->code, 0);
    EXPECT_FALSE(intent(0).discharging);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
