#include "core/thunderbots/sweeper.h"

#include <gtest/gtest.h>

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;
using Finding = Sweeper::Finding;

SweepPlan plan(int from_us, int to_us, int step_us, int kicksPerStep = 1) {
    SweepPlan made;
    made.robot = 3;
    made.from_us = from_us;
    made.to_us = to_us;
    made.step_us = step_us;
    made.kicksPerStep = kicksPerStep;
    return made;
}

std::vector<int> widths(const SweepPlan& asked) {
    const auto kicks = planSweep(asked).value();
    std::vector<int> all;
    for (const wire::KickTimes& times : kicks)
        all.push_back(wire::personTermsOf(times).width1_us);
    return all;
}

TEST(SweepPlan, GoesFromOneEndTowardsTheOtherAndNeverPast) {
    EXPECT_EQ(widths(plan(320, 640, 160)), (std::vector<int>{320, 480, 640}));
    EXPECT_EQ(widths(plan(320, 639, 160)), (std::vector<int>{320, 480}));
    EXPECT_EQ(widths(plan(640, 320, 160)), (std::vector<int>{640, 480, 320}));
    EXPECT_EQ(widths(plan(640, 640, 32)), (std::vector<int>{640}));
    EXPECT_EQ(widths(plan(320, 352, 32, 3)), (std::vector<int>{320, 320, 320, 352, 352, 352}));
    EXPECT_EQ(stepsOf(plan(0, 4064, 32)), 128);
}

TEST(SweepPlan, TheOtherPulseAndTheOffsetStayAsTheyAre) {
    SweepPlan asked = plan(320, 640, 320);
    asked.solenoid = 2;
    asked.otherWidth_us = 960;
    asked.offset_us = 128;
    const auto kicks = planSweep(asked);
    ASSERT_TRUE(kicks);
    EXPECT_EQ(wire::personTermsOf(kicks->at(0)), (wire::KickPulses{960, 320, 128}));
    EXPECT_EQ(wire::personTermsOf(kicks->at(1)), (wire::KickPulses{960, 640, 128}));
}

TEST(SweepPlan, NumbersPastTheirRangeAreRefusedByName) {
    const auto subjectOf = [](const SweepPlan& asked) {
        const auto kicks = planSweep(asked);
        EXPECT_FALSE(kicks);
        EXPECT_EQ(kicks.error().code, Errc::OutOfRange);
        EXPECT_EQ(stepsOf(asked), 0);
        return kicks.error().subject;
    };
    SweepPlan wrong = plan(320, 640, 32);
    wrong.robot = 16;
    EXPECT_EQ(subjectOf(wrong), "robot");
    wrong = plan(320, 640, 32);
    wrong.solenoid = 3;
    EXPECT_EQ(subjectOf(wrong), "solenoid");
    EXPECT_EQ(subjectOf(plan(-1, 640, 32)), "from");
    EXPECT_EQ(subjectOf(plan(320, 4065, 32)), "to");
    EXPECT_EQ(subjectOf(plan(320, 640, 31)), "step");
    EXPECT_EQ(subjectOf(plan(320, 640, 0)), "step");
    EXPECT_EQ(subjectOf(plan(320, 640, 32, 0)), "kicks per step");
    EXPECT_EQ(subjectOf(plan(320, 640, 32, 51)), "kicks per step");
    wrong = plan(320, 640, 32);
    wrong.pause = -1s;
    EXPECT_EQ(subjectOf(wrong), "pause");
    wrong = plan(320, 640, 32);
    wrong.chargeLimit = 0s;
    EXPECT_EQ(subjectOf(wrong), "charge limit");
}

TEST(SweepPlan, ItsKicksHaveToExist) {
    SweepPlan asked = plan(320, 4064, 32);
    asked.otherWidth_us = 320;
    asked.offset_us = -32;
    const auto tooLate = planSweep(asked);
    ASSERT_FALSE(tooLate);
    EXPECT_EQ(tooLate.error().code, Errc::NoEncoding);
    EXPECT_EQ(tooLate.error().subject, "solenoid 1");
    EXPECT_FALSE(planSweep(plan(0, 320, 32))) << "the first has no pulse";
}

class SweeperTest : public ::testing::Test {
  protected:
    void begin(const SweepPlan& asked) { sweeper.begin(asked, planSweep(asked).value(), true, now); }
    Finding look(bool charged, bool measuring = false) {
        RobotState state;
        state.freshness = Freshness::Current;
        state.readings.charged = charged;
        return sweeper.look(state, measuring, now);
    }

    Sweeper sweeper;
    TimePoint now{1s};
};

TEST_F(SweeperTest, EveryKickWaitsForAChargedCapacitorAndForWhatTheLastOneDid) {
    begin(plan(320, 640, 320));
    EXPECT_EQ(look(false), Finding::Wait);
    EXPECT_EQ(sweeper.progress()->stage, SweepStage::Charging);
    EXPECT_EQ(look(true), Finding::Kick);
    EXPECT_EQ(wire::personTermsOf(sweeper.due()).width1_us, 320);
    sweeper.kicked(now);
    EXPECT_EQ(look(true, true), Finding::Wait) << "it says charged still, of before the kick";
    EXPECT_EQ(sweeper.progress()->stage, SweepStage::Measuring);
    EXPECT_EQ(look(false, true), Finding::Wait);
    EXPECT_EQ(look(true), Finding::Kick);
    EXPECT_EQ(wire::personTermsOf(sweeper.due()).width1_us, 640);
    sweeper.kicked(now);
    EXPECT_EQ(look(true, true), Finding::Wait);
    EXPECT_EQ(look(true), Finding::Through);
    sweeper.end({});
    EXPECT_FALSE(sweeper.running());
    EXPECT_EQ(sweeper.progress()->given, 2);
    EXPECT_FALSE(sweeper.progress()->endedBy);
}

TEST_F(SweeperTest, WaitsOutThePause) {
    SweepPlan asked = plan(320, 640, 320);
    asked.pause = 60s;
    begin(asked);
    EXPECT_EQ(look(true), Finding::Kick) << "there is no pause before the first";
    sweeper.kicked(now);
    now += 59s;
    EXPECT_EQ(look(true), Finding::Wait);
    EXPECT_EQ(sweeper.progress()->stage, SweepStage::Pausing);
    EXPECT_EQ(look(false), Finding::Wait) << "what was charged a moment ago is not late";
    now += 1s;
    EXPECT_EQ(look(true), Finding::Kick);
}

TEST_F(SweeperTest, EndsWhereChargingTakesTooLong) {
    begin(plan(320, 640, 320));
    now += 29s;
    EXPECT_EQ(look(false), Finding::Wait);
    now += 1s;
    EXPECT_EQ(look(false, true), Finding::NotCharged);
    EXPECT_EQ(look(true), Finding::Kick);
}

TEST_F(SweeperTest, EndsWhereNobodyKnowsTheVoltage) {
    begin(plan(320, 640, 320));
    for (const Freshness freshness : {Freshness::NotHeard, Freshness::Waiting, Freshness::Stale}) {
        RobotState state;
        state.freshness = freshness;
        state.readings.charged = true;
        EXPECT_EQ(sweeper.look(state, false, now), Finding::Unknown);
    }
}

TEST_F(SweeperTest, OneThatHasEndedStaysEndedUntilTheNextBegins) {
    begin(plan(320, 640, 320));
    const std::uint64_t first = sweeper.number();
    sweeper.end(Errc::Cancelled);
    sweeper.end(Errc::StopLatched);
    EXPECT_EQ(sweeper.progress()->endedBy, Errc::Cancelled);
    EXPECT_FALSE(sweeper.running(3));
    begin(plan(320, 320, 32));
    EXPECT_TRUE(sweeper.running(3));
    EXPECT_FALSE(sweeper.running(2));
    EXPECT_NE(sweeper.number(), first);
}

}  // namespace
}  // namespace kickstand::thunderbots
