// The sweep and the kick log over a whole session: what it does on the wire, and that every way of stopping
// stops it.

#include "core/thunderbots/wire/readings.h"
#include "tests/session/safety_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;

SweepPlan shortPlan() {
    SweepPlan plan;
    plan.robot = 0;
    plan.from_us = 640;
    plan.to_us = 1280;
    plan.step_us = 320;
    return plan;
}

class Sweep : public SafetyTest {
  protected:
    void startCharged(const SweepPlan& plan = shortPlan()) {
        charge(0);
        ASSERT_TRUE(rig.waitUntil([this] { return rig.state().robots[0].readings.charged; }, 30s));
        ASSERT_TRUE(rig.ask(StartSweep{plan}));
        rig.forgetPackets();
    }
    std::optional<SweepProgress> progress() { return rig.state().sweep; }
    bool waitForKicks(int kicks) {
        return rig.waitUntil([this, kicks] { return progress()->given >= kicks; }, 2min);
    }
    bool waitForEnd() {
        return rig.waitUntil([this] { return rig.count(EventKind::SweepEnded) == 1; }, 5min);
    }
    /// That it is over for this reason, and that nothing comes after.
    void expectEnded(Errc why) {
        ASSERT_TRUE(waitForEnd());
        EXPECT_EQ(rig.last(EventKind::SweepEnded)->code, static_cast<std::int64_t>(why));
        rig.advance(300ms);
        ASSERT_TRUE(progress());
        EXPECT_FALSE(progress()->running());
        EXPECT_EQ(progress()->endedBy, why);
        EXPECT_FALSE(intent(0).sweeping);
        rig.forgetPackets();
        rig.advance(60s);
        EXPECT_EQ(kicksIn(rig.packets()), 0U);
    }
};

TEST_F(Sweep, GivesEveryKickOnceWithAChargedCapacitorAndMeasuresIt) {
    startCharged();
    ASSERT_TRUE(waitForEnd());
    EXPECT_EQ(rig.last(EventKind::SweepEnded)->code, 0);
    EXPECT_EQ(rig.last(EventKind::SweepEnded)->previous, 3);
    EXPECT_EQ(kicksIn(rig.packets()), 3U);
    const auto done = rig.robot(0).lastKicks;
    ASSERT_EQ(done.size(), 3U);
    rig.advance(50ms);
    const auto records = rig.state().kicks;
    ASSERT_EQ(records->size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(done[i].pulses[0].width_us, 640 + 320 * static_cast<int>(i));
        EXPECT_EQ(done[i].pulses[1].width_us, 0);
        EXPECT_GT(done[i].before_V, wire::kCapacitorCharged_V - 1);
        const KickRecord& record = records->at(i);
        EXPECT_EQ(record.cause, KickCause::Sweep);
        EXPECT_EQ(record.measure, KickMeasure::Recharged);
        EXPECT_NEAR(*record.before_V, done[i].before_V, 1);
        EXPECT_NEAR(*record.after_V, done[i].after_V, 8) << "the charger is quick beside the radio's pace";
        EXPECT_GT(*record.recharge, 0s);
    }
    EXPECT_LT(*records->at(0).drop_V(), *records->at(2).drop_V());
}

TEST_F(Sweep, SwitchesTheChargerOnAndBackToWhatItWas) {
    ASSERT_TRUE(rig.arm(0));
    ASSERT_TRUE(rig.ask(StartSweep{shortPlan()}));
    rig.advance(300ms);
    EXPECT_TRUE(rig.robot(0).charging);
    ASSERT_TRUE(waitForEnd());
    EXPECT_EQ(rig.last(EventKind::SweepEnded)->code, 0);
    EXPECT_FALSE(intent(0).charger);
    rig.advance(300ms);
    EXPECT_FALSE(rig.robot(0).charging);
    EXPECT_TRUE(intent(0).highVoltageArmed);
}

TEST_F(Sweep, NeedsTheRobotArmedAndAlive) {
    EXPECT_EQ(rig.refusal(StartSweep{shortPlan()}), Errc::NotArmed);
    SweepPlan missing = shortPlan();
    missing.robot = 9;
    EXPECT_EQ(rig.refusal(StartSweep{missing}), Errc::RobotNotAlive);
    ASSERT_TRUE(rig.arm(0));
    SweepPlan impossible = shortPlan();
    impossible.to_us = 9999;
    EXPECT_EQ(rig.refusal(StartSweep{impossible}), Errc::OutOfRange);
    rig.stop();
    EXPECT_EQ(rig.refusal(StartSweep{shortPlan()}), Errc::StopLatched);
    EXPECT_FALSE(progress());
}

TEST_F(Sweep, HasItsRobotToItself) {
    startCharged();
    EXPECT_EQ(rig.refusal(StartSweep{shortPlan()}), Errc::SweepRunning);
    EXPECT_EQ(rig.refusal(Kick{0, kKick}), Errc::SweepRunning);
    EXPECT_EQ(rig.refusal(SetAutokick{maskOf(0), true, kKick}), Errc::SweepRunning);
    EXPECT_EQ(rig.refusal(Discharge{0, true}), Errc::SweepRunning);
    ASSERT_TRUE(rig.arm(1));
    EXPECT_FALSE(rig.refusal(Kick{1, kKick})) << "others are free";
}

TEST_F(Sweep, APersonStopsItAtAnyTime) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    ASSERT_TRUE(rig.ask(StopSweep{}));
    expectEnded(Errc::Cancelled);
    EXPECT_TRUE(intent(0).charger) << "it was on before";
    EXPECT_EQ(latched(), StopReason::None);
    EXPECT_FALSE(rig.refusal(StopSweep{})) << "there is nothing to stop, and that is fine";
}

TEST_F(Sweep, StopEndsItAndTheCharger) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    rig.forgetPackets();
    rig.stop();
    rig.advance(20ms);
    EXPECT_EQ(brakedRobots(), kAllRobots);
    for (const SentBlock& sent : blocksIn(rig.packets()))
        EXPECT_EQ(sent.block, wire::brakedBlock());
    expectEnded(Errc::StopLatched);
    EXPECT_FALSE(intent(0).charger);
}

TEST_F(Sweep, DisarmingEndsItAndTheCharger) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    ASSERT_TRUE(rig.ask(ArmHighVoltage{maskOf(0), false}));
    expectEnded(Errc::NotArmed);
    EXPECT_FALSE(intent(0).charger);
}

TEST_F(Sweep, AStaleHeartbeatEndsIt) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    rig.beat(false);
    expectEnded(Errc::StopLatched);
    EXPECT_EQ(latched(), StopReason::HeartbeatStale);
}

TEST_F(Sweep, ALostRobotEndsIt) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(waitForEnd());
    EXPECT_NE(rig.last(EventKind::SweepEnded)->code, 0);
    rig.forgetPackets();
    rig.advance(60s);
    EXPECT_EQ(kicksIn(rig.packets()), 0U);
    EXPECT_EQ(rig.state().kicks->back().measure, KickMeasure::Lost);
}

TEST_F(Sweep, ALostLinkEndsItAndNothingIsTakenUpAgain) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    rig.simulate("plugged", 0);
    ASSERT_TRUE(waitForEnd());
    EXPECT_EQ(rig.last(EventKind::SweepEnded)->code, static_cast<std::int64_t>(Errc::Disconnected));
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.isRunning(); }, 30s));
    rig.rearm();
    rig.forgetPackets();
    rig.advance(60s);
    EXPECT_EQ(kicksIn(rig.packets()), 0U);
    EXPECT_FALSE(progress()->running());
}

TEST_F(Sweep, TheEmergencyStopEndsIt) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    rig.simulate("e-stop", static_cast<double>(wire::EStop::Stop));
    expectEnded(Errc::StopLatched);
}

TEST_F(Sweep, ACapacitorThatDoesNotChargeEndsIt) {
    SweepPlan plan = shortPlan();
    plan.chargeLimit = 3s;
    startCharged(plan);
    ASSERT_TRUE(waitForKicks(1));
    ASSERT_TRUE(rig.ask(SetCharger{maskOf(0), false}));
    expectEnded(Errc::NotCharging);
}

TEST_F(Sweep, AKickThatTheDongleDoesNotTakeEndsIt) {
    startCharged();
    ASSERT_TRUE(waitForKicks(1));
    // Messages to a robot that does not answer fill the dongle's buffers.
    rig.simulate("loss", 1, 1);
    for (int i = 0; i < 8; ++i)
        rig.give(SetTestMode{maskOf(1), {wire::TestClass::Lamp, 0}});
    ASSERT_TRUE(waitForEnd());
    EXPECT_NE(rig.last(EventKind::SweepEnded)->code, 0);
}

TEST_F(Sweep, ThePauseIsKept) {
    SweepPlan plan = shortPlan();
    plan.pause = 20s;
    startCharged(plan);
    ASSERT_TRUE(waitForEnd());
    const auto done = rig.robot(0).lastKicks;
    ASSERT_EQ(done.size(), 3U);
    EXPECT_GE(done[1].time - done[0].time, 19s);
    EXPECT_GE(done[2].time - done[1].time, 19s);
}

TEST_F(Sweep, AutokicksAreLoggedWithTheTimesThatWereArmed) {
    charge(0);
    ASSERT_TRUE(rig.ask(SetAutokick{maskOf(0), true, kKick}));
    rig.advance(300ms);
    rig.simulate("ball", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::KickMeasured) == 1; }, 60s));
    rig.advance(50ms);
    const KickRecord record = rig.state().kicks->back();
    EXPECT_EQ(record.cause, KickCause::Autokick);
    EXPECT_EQ(record.times, kKick);
    EXPECT_GT(*record.drop_V(), 30);
    EXPECT_EQ(record.measure, KickMeasure::Recharged);
}

TEST_F(Sweep, ADischargeIsNoRowOfKicks) {
    charge(0);
    ASSERT_TRUE(rig.ask(Discharge{0, true}));
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::DischargeEnded) == 1; }, 10min));
    EXPECT_TRUE(rig.state().kicks->empty());
}

TEST_F(Sweep, TheTimeToChargedIsMeasured) {
    charge(0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::Charged) == 1; }, 30s));
    rig.advance(50ms);
    const ChargeRecord record = rig.state().charges[0];
    ASSERT_TRUE(record.toCharged);
    EXPECT_GT(*record.toCharged, 1s);
    EXPECT_LT(*record.toCharged, 10s);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
