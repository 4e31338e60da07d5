#include "core/thunderbots/bench_checker.h"

#include <gtest/gtest.h>

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

CheckPlan planFor(RobotMask robots) {
    CheckPlan plan;
    plan.robots = robots;
    return plan;
}

std::size_t countOf(const std::vector<CheckStep>& steps, CheckKind kind) {
    return static_cast<std::size_t>(std::count_if(
        steps.begin(), steps.end(), [kind](const CheckStep& step) { return step.kind == kind; }));
}

TEST(CheckPlan, ChecksEveryWheelBothWaysAndEveryTestMode) {
    const auto steps = planCheck(planFor(maskOf(3))).value();
    EXPECT_EQ(steps.front().kind, CheckKind::Ready);
    EXPECT_EQ(steps.back().kind, CheckKind::Discharge) << "a robot is left without charge";
    EXPECT_EQ(countOf(steps, CheckKind::Wheel), 8U);
    EXPECT_EQ(countOf(steps, CheckKind::Lights), 1U + 5U + 4U + 4U + 1U);
    for (const CheckStep& step : steps)
        EXPECT_EQ(step.robot, 3);
}

TEST(CheckPlan, LeavesOutWhatIsNotAskedFor) {
    CheckPlan plan = planFor(maskOf(0));
    plan.wheels = plan.dribbler = plan.highVoltage = plan.lights = false;
    const auto steps = planCheck(plan).value();
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_EQ(steps[1].kind, CheckKind::Battery);
}

TEST(CheckPlan, OneRobotComesAfterAnother) {
    const auto steps = planCheck(planFor(static_cast<RobotMask>(maskOf(9) | maskOf(2)))).value();
    EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end(),
                               [](const CheckStep& a, const CheckStep& b) { return a.robot < b.robot; }));
    EXPECT_EQ(countOf(steps, CheckKind::Ready), 2U);
}

TEST(CheckPlan, LimitsPastTheirRangeAreRefusedByName) {
    for (const CheckLimitInfo& info : checkLimitInfos()) {
        for (const double wrong :
             {info.lowest - 1, info.highest + 1, std::numeric_limits<double>::quiet_NaN()}) {
            CheckPlan plan = planFor(1);
            plan.limits.*info.member = wrong;
            const auto steps = planCheck(plan);
            ASSERT_FALSE(steps) << info.name << ' ' << wrong;
            EXPECT_EQ(steps.error().code, Errc::OutOfRange);
            EXPECT_EQ(steps.error().subject, info.name);
        }
    }
    EXPECT_EQ(planCheck(planFor(0)).error().code, Errc::BadArgument);
}

/// A checker with a robot in its hand.
class Checker : public ::testing::Test {
  protected:
    void begin(CheckPlan plan) {
        checker.begin(plan, planCheck(plan).value(), now);
        robot.live = true;
        robot.freshness = Freshness::Current;
        robot.readings.battery_V = 16;
        robot.readings.dribbler_C = 25;
    }
    CheckDemand look(Duration later = 10ms) {
        now += later;
        return checker.look({robot, kick ? &*kick : nullptr, discharging, true}, now);
    }
    /// Looks until a question is open or another row is at work.
    void runStep() {
        const std::size_t row = progress().current;
        for (int i = 0; i < 2000 && progress().running(); ++i) {
            look();
            if (progress().current != row || progress().stage == CheckStage::Asking) return;
        }
    }
    void answer(CheckAnswer what) { ASSERT_TRUE(checker.answer(progress().current, what, now)); }
    const CheckProgress& progress() {
        held = checker.progress();
        return *held;
    }
    const CheckRow& row(std::size_t index) { return progress().rows[index]; }

    BenchChecker checker;
    RobotState robot;
    std::optional<KickRecord> kick;
    bool discharging = false;
    TimePoint now{};
    std::shared_ptr<const CheckProgress> held;
};

TEST_F(Checker, NothingMovesBeforeAPersonSaysSo) {
    begin(planFor(maskOf(0)));
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(look(1s), CheckDemand{});
    EXPECT_EQ(progress().stage, CheckStage::Asking);
    EXPECT_EQ(progress().current, 0U);
}

TEST_F(Checker, AWheelRunsForItsTimeAndIsThenAskedFor) {
    CheckPlan plan = planFor(maskOf(0));
    plan.limits.wheelSpeed = 40;
    begin(plan);
    look();
    answer(CheckAnswer::Yes);
    runStep();
    EXPECT_EQ(row(1).verdict, CheckVerdict::Passed);
    EXPECT_EQ(look().wheels, (WheelSpeeds{40, 0, 0, 0}));
    EXPECT_EQ(look(1400ms).wheels, (WheelSpeeds{40, 0, 0, 0}));
    EXPECT_EQ(look(200ms), CheckDemand{}) << "it stands while the question is open";
    EXPECT_EQ(progress().stage, CheckStage::Asking);
    answer(CheckAnswer::Again);
    EXPECT_EQ(look().wheels, (WheelSpeeds{40, 0, 0, 0}));
    runStep();
    answer(CheckAnswer::No);
    EXPECT_EQ(row(2).verdict, CheckVerdict::NotSeen);
    EXPECT_EQ(look().wheels, (WheelSpeeds{-40, 0, 0, 0}));
    EXPECT_EQ(verdictOf(progress(), 0), CheckVerdict::Failed);
}

TEST_F(Checker, AnAnswerToAnotherQuestionIsRefused) {
    begin(planFor(maskOf(0)));
    EXPECT_FALSE(checker.answer(0, CheckAnswer::Yes, now)) << "it has not been asked yet";
    look();
    EXPECT_FALSE(checker.answer(1, CheckAnswer::Yes, now));
    EXPECT_FALSE(checker.answer(0, CheckAnswer::Again, now)) << "there is nothing to repeat";
    EXPECT_TRUE(checker.answer(0, CheckAnswer::Yes, now));
    EXPECT_FALSE(checker.answer(0, CheckAnswer::Yes, now));
}

TEST_F(Checker, ALowBatteryFailsWithItsValueAndTheRestGoesOn) {
    begin(planFor(maskOf(0)));
    robot.readings.battery_V = 14.2;
    look();
    answer(CheckAnswer::Yes);
    runStep();
    EXPECT_EQ(row(1).verdict, CheckVerdict::Failed);
    EXPECT_DOUBLE_EQ(*row(1).value, 14.2);
    EXPECT_DOUBLE_EQ(*row(1).limit, 15.0);
    EXPECT_EQ(progress().current, 2U);
    EXPECT_TRUE(progress().running());
}

TEST_F(Checker, AHotDribblerFailsWithoutAQuestion) {
    CheckPlan plan = planFor(maskOf(0));
    plan.wheels = plan.highVoltage = plan.lights = false;
    begin(plan);
    look();
    answer(CheckAnswer::Yes);
    runStep();
    EXPECT_TRUE(look().dribbler);
    robot.readings.dribbler_C = 71;
    runStep();
    EXPECT_EQ(row(2).verdict, CheckVerdict::Failed);
    EXPECT_DOUBLE_EQ(*row(2).value, 71);
}

TEST_F(Checker, TheSagIsTheDeepestReadingUnderLoad) {
    CheckPlan plan = planFor(maskOf(0));
    plan.dribbler = plan.highVoltage = plan.lights = false;
    begin(plan);
    look();
    answer(CheckAnswer::Yes);
    while (progress().rows[progress().current].step.kind != CheckKind::Load) {
        runStep();
        if (progress().stage == CheckStage::Asking) answer(CheckAnswer::Yes);
    }
    EXPECT_EQ(look().wheels, (WheelSpeeds{60, 60, 60, 60}));
    robot.readings.battery_V = 14.8;
    look();
    robot.readings.battery_V = 15.5;
    runStep();
    EXPECT_FALSE(progress().running());
    EXPECT_DOUBLE_EQ(*progress().rows.back().value, 16 - 14.8);
    EXPECT_EQ(progress().rows.back().verdict, CheckVerdict::Failed);
}

class Charging : public Checker {
  protected:
    void beginCharging() {
        CheckPlan plan = planFor(maskOf(0));
        plan.wheels = plan.dribbler = plan.lights = false;
        begin(plan);
        look();
        answer(CheckAnswer::Yes);
        runStep();
    }
    void reach(double volts) {
        robot.readings.capacitor_V = volts;
        robot.readings.charged = volts > 215;
    }
};

TEST_F(Charging, AFullCapacitorIsEmptiedFirst) {
    reach(216);
    beginCharging();
    EXPECT_TRUE(look().discharge);
    EXPECT_EQ(progress().stage, CheckStage::Discharging);
    discharging = true;
    EXPECT_TRUE(look(20s).discharge);
    discharging = false;
    reach(24);
    EXPECT_TRUE(look().charger);
    look(3s);
    reach(216);
    look(1s);
    EXPECT_EQ(row(2).verdict, CheckVerdict::Passed);
    EXPECT_NEAR(*row(2).value, 4, 0.05) << "from empty, without the time that emptying took";
}

TEST_F(Charging, ASlowChargerFailsAndNoKickIsGiven) {
    beginCharging();
    EXPECT_TRUE(look().charger);
    EXPECT_FALSE(look(9s).charger);
    EXPECT_EQ(row(2).verdict, CheckVerdict::Failed);
    EXPECT_EQ(row(2).why, Errc::NotCharging);
    EXPECT_FALSE(row(2).value);
    look();
    EXPECT_EQ(row(3).step.kind, CheckKind::Kick);
    EXPECT_EQ(row(3).verdict, CheckVerdict::Skipped);
    look();
    EXPECT_EQ(row(4).verdict, CheckVerdict::Passed) << "it is empty";
    EXPECT_FALSE(progress().running());
    EXPECT_FALSE(allPassed(progress()));
}

TEST_F(Charging, AKickIsGivenOnceAndItsDropIsJudged) {
    beginCharging();
    look();
    reach(216);
    look();
    int kicks = 0;
    for (int i = 0; i < 150; ++i) {
        const CheckDemand demand = look();
        EXPECT_FALSE(demand.charger) << "it would fill up what the kick takes";
        if (demand.kick) ++kicks;
    }
    EXPECT_EQ(kicks, 1);
    kick.emplace();
    kick->number = 1;
    kick->before_V = 216;
    kick->after_V = 150;
    runStep();
    EXPECT_EQ(row(3).verdict, CheckVerdict::Passed);
    EXPECT_DOUBLE_EQ(*row(3).value, 66);
}

TEST_F(Charging, AKickThatLeavesNoRecordFails) {
    beginCharging();
    look();
    reach(216);
    look();
    kick.emplace();
    kick->number = 7;
    kick->before_V = 216;
    kick->after_V = 150;
    look();
    for (int i = 0; i < 300; ++i)
        look();
    EXPECT_EQ(row(3).verdict, CheckVerdict::Failed) << "an older kick is not this one";
    EXPECT_EQ(row(3).why, Errc::KickExpired);
}

TEST_F(Checker, ALostRobotFailsOnlyItself) {
    begin(planFor(static_cast<RobotMask>(maskOf(1) | maskOf(4))));
    look();
    answer(CheckAnswer::Yes);
    look();
    EXPECT_EQ(checker.robot(), 1);
    checker.robotLost(Errc::RobotNotAlive);
    EXPECT_EQ(checker.robot(), 4);
    EXPECT_EQ(verdictOf(progress(), 1), CheckVerdict::Failed);
    EXPECT_EQ(verdictOf(progress(), 4), CheckVerdict::Waiting);
    look();
    EXPECT_EQ(progress().stage, CheckStage::Asking);
}

TEST_F(Checker, ARobotThatIsSkippedIsSkippedWhole) {
    begin(planFor(static_cast<RobotMask>(maskOf(1) | maskOf(4))));
    look();
    answer(CheckAnswer::Skip);
    EXPECT_EQ(checker.robot(), 4);
    EXPECT_EQ(verdictOf(progress(), 1), CheckVerdict::Skipped);
}

TEST_F(Checker, EndingItLeavesTheRestUndone) {
    begin(planFor(maskOf(1)));
    look();
    checker.end(Errc::StopLatched);
    EXPECT_FALSE(checker.running());
    EXPECT_EQ(checker.robot(), -1);
    EXPECT_EQ(progress().endedBy, Errc::StopLatched);
    EXPECT_EQ(verdictOf(progress(), 1), CheckVerdict::Waiting);
    EXPECT_FALSE(allPassed(progress()));
    EXPECT_EQ(look(), CheckDemand{});
}

}  // namespace
}  // namespace kickstand::thunderbots
