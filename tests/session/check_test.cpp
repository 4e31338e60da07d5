// The bench check over a whole session: what it does on the wire, what it finds wrong with robots that have a
// fault, and that every way of stopping stops it.

#include <set>

#include "core/thunderbots/wire/readings.h"
#include "tests/session/safety_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;

class Check : public SafetyTest {
  protected:
    void start(RobotMask robots = maskOf(0)) {
        plan.robots = robots;
        for (int robot = 0; robot < kRobots; ++robot) {
            const bool live = contains(robots, robot) && rig.state().robots.at(at(robot)).live;
            if (plan.highVoltage && live) {
                ASSERT_TRUE(rig.arm(robot));
            }
        }
        ASSERT_TRUE(rig.ask(StartCheck{plan}));
    }
    static std::size_t at(int robot) { return static_cast<std::size_t>(robot); }
    CheckProgress progress() { return *rig.state().check; }
    bool waitForQuestion() {
        rig.advance(20ms);
        return rig.waitUntil(
            [this] {
                const auto check = rig.state().check;
                return !check->running() || check->stage == CheckStage::Asking;
            },
            5min);
    }
    /// What a person who looks at the robot says.
    CheckAnswer look(const CheckStep& step) {
        if (step.kind == CheckKind::Wheel)
            return movedWheels.contains({step.robot, step.wheel}) ? CheckAnswer::Yes : CheckAnswer::No;
        if (step.kind == CheckKind::Lights) {
            const bool shown = rig.robot(step.robot).testMode == step.mode;
            return shown ? CheckAnswer::Yes : CheckAnswer::No;
        }
        return CheckAnswer::Yes;
    }
    /// Answers every question as somebody does who watches.
    void goThrough(const std::function<bool()>& enough = [] { return false; }) {
        while (!enough()) {
            const bool asked = rig.waitUntil(
                [this] {
                    watch();
                    const auto check = rig.state().check;
                    return !check->running() || check->stage == CheckStage::Asking;
                },
                5min);
            ASSERT_TRUE(asked);
            const CheckProgress now = progress();
            if (!now.running()) return;
            // The lights take their way to the robot.
            rig.advance(600ms);
            ASSERT_TRUE(rig.ask(AnswerCheck{now.current, look(now.rows[now.current].step)}));
            movedWheels.clear();
            rig.advance(20ms);
        }
    }
    void watch() {
        for (int robot = 0; robot < 4; ++robot) {
            for (int wheel = 1; wheel <= kWheels; ++wheel) {
                if (std::abs(rig.robot(robot).wheelSpeeds.at(at(wheel - 1))) > 10)
                    movedWheels.insert({robot, wheel});
            }
        }
    }
    CheckRow rowOf(CheckKind kind, int wheel = 0) {
        const CheckProgress now = progress();
        for (const CheckRow& row : now.rows) {
            if (row.step.kind == kind && row.step.wheel == wheel) return row;
        }
        ADD_FAILURE() << "no such row";
        return {};
    }
    void expectEnded(Errc why) {
        ASSERT_TRUE(rig.waitUntil([this] { return !rig.state().check->running(); }, 5s));
        EXPECT_EQ(progress().endedBy, why);
        EXPECT_EQ(rig.last(EventKind::CheckEnded)->code, static_cast<std::int64_t>(why));
        // Without its dongle a robot brakes by its own time-out.
        rig.advance(1500ms);
        EXPECT_FALSE(rig.anyWheelTurns());
        EXPECT_FALSE(rig.robot(0).charging);
        EXPECT_FALSE(intent(0).checking);
    }

    CheckPlan plan;
    std::set<std::pair<int, int>> movedWheels;
};

TEST_F(Check, ASoundRobotPassesEveryStepAndIsLeftEmptyAndDisarmed) {
    start();
    goThrough();
    for (const CheckRow& row : progress().rows)
        EXPECT_EQ(row.verdict, CheckVerdict::Passed) << name(row.step.kind) << ' ' << row.step.wheel;
    EXPECT_TRUE(allPassed(progress()));
    EXPECT_GT(rig.robot(0).kicks, 100U) << "one kick, and the pulses of the discharge";
    EXPECT_LE(rig.robot(0).capacitor_V, wire::kCapacitorDischarged_V + 1);
    EXPECT_NEAR(*rowOf(CheckKind::Charge).value, 3.4, 1.0);
    EXPECT_NEAR(*rowOf(CheckKind::Kick).value, 71, 10);
    EXPECT_GT(*rowOf(CheckKind::Load).value, 0.05);
    EXPECT_FALSE(intent(0).active());
    EXPECT_EQ(rig.last(EventKind::RobotChecked)->code, static_cast<std::int64_t>(CheckVerdict::Passed));
    EXPECT_EQ(rig.last(EventKind::CheckEnded)->code, 0);
}

TEST_F(Check, WheelsStayWithinTheSpeedAndTheRampThatWereSet) {
    plan.highVoltage = plan.lights = plan.dribbler = false;
    plan.limits.wheelSpeed = 80;
    start();
    rig.forgetPackets();
    goThrough();
    int fastest = 0;
    std::map<int, int> steps;
    for (const SentBlock& sent : blocksIn(rig.packets())) {
        if (sent.robot != 0) {
            EXPECT_EQ(sent.block, wire::brakedBlock()) << "robot " << sent.robot;
            continue;
        }
        for (const int speed : sent.block.wheels) {
            fastest = std::max(fastest, std::abs(speed));
            ++steps[speed];
        }
    }
    EXPECT_EQ(fastest, 80);
    EXPECT_GT(steps.size(), 20U) << "it is ramped, forwards and backwards";
}

TEST_F(Check, ADeadWheelIsFound) {
    rig.simulate("dead-wheels", 2, 0);
    plan.highVoltage = plan.lights = false;
    start();
    goThrough();
    EXPECT_EQ(rowOf(CheckKind::Wheel, 1).verdict, CheckVerdict::Passed);
    EXPECT_EQ(rowOf(CheckKind::Wheel, 2).verdict, CheckVerdict::NotSeen);
    EXPECT_EQ(verdictOf(progress(), 0), CheckVerdict::Failed);
    EXPECT_FALSE(progress().endedBy) << "the rest is checked all the same";
}

TEST_F(Check, ABrokenChargerIsFound) {
    rig.simulate("broken-charger", 1, 0);
    plan.wheels = plan.dribbler = plan.lights = false;
    start();
    rig.forgetPackets();
    goThrough();
    EXPECT_EQ(rowOf(CheckKind::Charge).verdict, CheckVerdict::Failed);
    EXPECT_EQ(rowOf(CheckKind::Kick).verdict, CheckVerdict::Skipped);
    EXPECT_EQ(kicksIn(rig.packets()), 0U);
}

TEST_F(Check, AWeakBatteryIsFound) {
    rig.simulate("battery", 14.5, 0);
    rig.advance(1s);
    plan.wheels = plan.dribbler = plan.lights = plan.highVoltage = false;
    start();
    goThrough();
    EXPECT_EQ(rowOf(CheckKind::Battery).verdict, CheckVerdict::Failed);
    EXPECT_NEAR(*rowOf(CheckKind::Battery).value, 14.5, 0.1);
}

TEST_F(Check, AHotDribblerIsFound) {
    rig.simulate("temperature", 75, 0);
    rig.advance(1s);
    plan.wheels = plan.lights = plan.highVoltage = false;
    start();
    goThrough();
    EXPECT_EQ(rowOf(CheckKind::Dribbler).verdict, CheckVerdict::Failed);
}

TEST_F(Check, AChargedRobotIsEmptiedBeforeItsChargeIsTimed) {
    charge(0);
    plan.wheels = plan.dribbler = plan.lights = false;
    start();
    goThrough();
    EXPECT_EQ(rowOf(CheckKind::Charge).verdict, CheckVerdict::Passed);
    EXPECT_GT(*rowOf(CheckKind::Charge).value, 2.5) << "not from where it was";
}

TEST_F(Check, ItIsRefusedWhereItCouldNotBeDone) {
    plan.robots = maskOf(0);
    EXPECT_EQ(rig.refusal(StartCheck{plan}), Errc::NotArmed);
    plan.robots = maskOf(9);
    EXPECT_EQ(rig.refusal(StartCheck{plan}), Errc::RobotNotAlive);
    plan.robots = 0;
    EXPECT_EQ(rig.refusal(StartCheck{plan}), Errc::BadArgument);
    plan.robots = maskOf(0);
    ASSERT_TRUE(rig.arm(0));
    ASSERT_TRUE(rig.ask(SetWheelLimit{50}));
    EXPECT_EQ(rig.refusal(StartCheck{plan}), Errc::OutOfRange);
    plan.limits.wheelSpeed = 50;
    rig.stop();
    EXPECT_EQ(rig.refusal(StartCheck{plan}), Errc::StopLatched);
    EXPECT_TRUE(progress().rows.empty());
    EXPECT_EQ(rig.refusal(AnswerCheck{0, CheckAnswer::Yes}), Errc::BadArgument);
    EXPECT_FALSE(rig.refusal(StopCheck{})) << "there is nothing to stop, and that is fine";
}

TEST_F(Check, ItHasItsRobotToItself) {
    start();
    ASSERT_TRUE(waitForQuestion());
    EXPECT_EQ(rig.refusal(StartCheck{plan}), Errc::CheckRunning);
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {10, 0, 0, 0}}), Errc::CheckRunning);
    EXPECT_EQ(rig.refusal(SetDribbler{maskOf(0), true}), Errc::CheckRunning);
    EXPECT_EQ(rig.refusal(SetCharger{maskOf(0), true}), Errc::CheckRunning);
    EXPECT_EQ(rig.refusal(Kick{0, kKick}), Errc::CheckRunning);
    EXPECT_EQ(rig.refusal(Discharge{0, true}), Errc::CheckRunning);
    EXPECT_EQ(rig.refusal(SetAutokick{maskOf(0), true, kKick}), Errc::CheckRunning);
    EXPECT_EQ(rig.refusal(SetTestMode{maskOf(0), {wire::TestClass::Lamp, 0}, TestModeWay::DriveBlock}),
              Errc::CheckRunning);
    EXPECT_FALSE(rig.refusal(SetWheels{maskOf(1), {10, 0, 0, 0}})) << "others are free";
}

/// One whose first wheel runs.
class RunningCheck : public Check {
  protected:
    void SetUp() override {
        Check::SetUp();
        start(static_cast<RobotMask>(maskOf(0) | maskOf(2)));
        ASSERT_TRUE(waitForQuestion());
        ASSERT_TRUE(rig.ask(AnswerCheck{0, CheckAnswer::Yes}));
        ASSERT_TRUE(rig.waitUntil([this] { return rig.anyWheelTurns(); }));
        rig.forgetPackets();
    }
};

TEST_F(RunningCheck, StopEndsItAndBrakes) {
    rig.stop();
    rig.advance(20ms);
    EXPECT_EQ(brakedRobots(), kAllRobots);
    for (const SentBlock& sent : blocksIn(rig.packets()))
        EXPECT_EQ(sent.block, wire::brakedBlock());
    expectEnded(Errc::StopLatched);
}

TEST_F(RunningCheck, APersonEndsIt) {
    ASSERT_TRUE(rig.ask(StopCheck{}));
    expectEnded(Errc::Cancelled);
    EXPECT_EQ(latched(), StopReason::None);
}

TEST_F(RunningCheck, BrakingOrDisarmingItsRobotEndsIt) {
    ASSERT_TRUE(rig.ask(Brake{maskOf(0)}));
    expectEnded(Errc::Cancelled);
    ASSERT_TRUE(rig.arm(0));
    plan.robots = maskOf(0);
    ASSERT_TRUE(rig.ask(StartCheck{plan}));
    ASSERT_TRUE(waitForQuestion());
    ASSERT_TRUE(rig.ask(ArmHighVoltage{maskOf(0), false}));
    expectEnded(Errc::NotArmed);
}

TEST_F(RunningCheck, SwitchingSomethingOffByHandEndsIt) {
    const Command offs[] = {SetDribbler{maskOf(0), false}, SetCharger{maskOf(0), false}, Discharge{0, false}};
    for (const Command& off : offs) {
        ASSERT_TRUE(rig.ask(off));
        expectEnded(Errc::Cancelled);
        ASSERT_TRUE(rig.arm(0));
        plan.robots = maskOf(0);
        ASSERT_TRUE(rig.ask(StartCheck{plan}));
        ASSERT_TRUE(waitForQuestion());
    }
}

TEST_F(RunningCheck, AStaleHeartbeatEndsIt) {
    rig.beat(false);
    expectEnded(Errc::StopLatched);
    EXPECT_EQ(latched(), StopReason::HeartbeatStale);
}

TEST_F(RunningCheck, TheEmergencyStopEndsIt) {
    rig.simulate("e-stop", static_cast<double>(wire::EStop::Stop));
    expectEnded(Errc::StopLatched);
}

TEST_F(RunningCheck, ALostLinkEndsItAndNothingIsTakenUpAgain) {
    rig.simulate("plugged", 0);
    expectEnded(Errc::Disconnected);
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.isRunning(); }, 30s));
    rig.rearm();
    rig.advance(60s);
    EXPECT_FALSE(progress().running());
    EXPECT_FALSE(rig.anyWheelTurns());
}

TEST_F(RunningCheck, ALostRobotFailsOnlyItselfAndTheNextWaitsForAPerson) {
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return rig.count(EventKind::RobotLost) == 1; }, 60s));
    rig.advance(50ms);
    EXPECT_EQ(latched(), StopReason::None);
    EXPECT_EQ(verdictOf(progress(), 0), CheckVerdict::Failed);
    ASSERT_TRUE(waitForQuestion());
    const CheckProgress now = progress();
    EXPECT_EQ(now.rows[now.current].step.robot, 2);
    EXPECT_EQ(now.rows[now.current].step.kind, CheckKind::Ready);
    rig.advance(10s);
    EXPECT_FALSE(rig.anyWheelTurns());
    goThrough();
    EXPECT_EQ(verdictOf(progress(), 2), CheckVerdict::Passed);
    EXPECT_FALSE(allPassed(progress()));
}

TEST_F(RunningCheck, ALostRobotStopsEverythingWhileAnotherMovesToo) {
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(3), {20, 20, 20, 20}}));
    rig.simulate("dead", 1, 0);
    ASSERT_TRUE(rig.waitUntil([this] { return latched() == StopReason::RobotLost; }, 60s));
    expectEnded(Errc::StopLatched);
}

TEST_F(RunningCheck, RadiosThatFailEndItAsALostLink) {
    rig.simulate("dead", 1, 0);
    rig.simulate("radio-failure", 0);
    ASSERT_TRUE(rig.waitUntil([this] { return !rig.state().check->running(); }, 60s));
    EXPECT_NE(latched(), StopReason::None);
}

TEST_F(Check, ARobotThatIsNotThereFailsWhenItsTurnComes) {
    rig.simulate("dead", 1, 1);
    ASSERT_TRUE(rig.waitUntil([this] { return !rig.state().robots[1].live; }, 60s));
    plan.wheels = plan.dribbler = plan.lights = plan.highVoltage = false;
    start(0b0111);
    goThrough();
    EXPECT_EQ(verdictOf(progress(), 0), CheckVerdict::Passed);
    EXPECT_EQ(verdictOf(progress(), 1), CheckVerdict::Failed);
    EXPECT_EQ(verdictOf(progress(), 2), CheckVerdict::Passed);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
