#include "core/thunderbots/robot_driver.h"

#include <gtest/gtest.h>

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

constexpr WheelSpeeds kAll(int speed) {
    return {speed, speed, speed, speed};
}

class RobotDriverTest : public ::testing::Test {
  protected:
    Result<void> set(const WheelSpeeds& wheels, bool held = false) {
        auto done = driver.setWheels(wheels, held, kStartingWheelLimit, now);
        if (done) driver.advance(now, true);
        return done;
    }
    void pass(Duration span) {
        now += span;
        driver.advance(now, true);
    }
    int speed() { return driver.block().wheels[0]; }

    TimePoint now{5s};
    RobotDriver driver;
};

TEST_F(RobotDriverTest, BeginsBrakedWithEverythingOff) {
    EXPECT_EQ(driver.block(), wire::brakedBlock());
    EXPECT_FALSE(driver.intent().active());
}

TEST_F(RobotDriverTest, RampsTwoHundredUnitsASecondOutwards) {
    ASSERT_TRUE(set(kAll(100)));
    EXPECT_TRUE(driver.block().run);
    EXPECT_EQ(speed(), 0);
    pass(10ms);
    EXPECT_EQ(speed(), 2);
    pass(240ms);
    EXPECT_EQ(speed(), 50);
    pass(249ms);
    EXPECT_EQ(speed(), 99);
    pass(1ms);
    EXPECT_EQ(speed(), 100);
    EXPECT_FALSE(driver.ramping());
}

TEST_F(RobotDriverTest, GetsNoCreditForTimeAtASteadySpeed) {
    ASSERT_TRUE(set(kAll(10)));
    pass(1s);
    ASSERT_EQ(speed(), 10);
    now += 10s;
    ASSERT_TRUE(set(kAll(100)));
    EXPECT_EQ(speed(), 10);
    pass(100ms);
    EXPECT_EQ(speed(), 30);
}

TEST_F(RobotDriverTest, FollowsTowardsZeroAtOnce) {
    ASSERT_TRUE(set(kAll(100)));
    pass(1s);
    ASSERT_TRUE(set(kAll(20)));
    EXPECT_EQ(speed(), 20);
    ASSERT_TRUE(set(kAll(0)));
    EXPECT_EQ(speed(), 0);
}

TEST_F(RobotDriverTest, PassesThroughZeroWhenTheDirectionTurns) {
    ASSERT_TRUE(set(kAll(100)));
    pass(1s);
    ASSERT_TRUE(set(kAll(-100)));
    EXPECT_EQ(speed(), 0);
    pass(100ms);
    EXPECT_EQ(speed(), -20);
}

TEST_F(RobotDriverTest, FollowsAtOnceWithoutARamp) {
    ASSERT_TRUE(driver.setWheels(kAll(1000), false, 1023, now));
    driver.advance(now, false);
    EXPECT_EQ(speed(), 1000);
}

TEST_F(RobotDriverTest, RefusesWhatIsPastTheLimitAndNamesTheWheel) {
    const auto refused = set({0, 0, -101, 0});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::OutOfRange);
    EXPECT_EQ(refused.error().subject, "wheel3");
    EXPECT_EQ(refused.error().lowest, -100);
    EXPECT_EQ(refused.error().highest, 100);
    EXPECT_EQ(refused.error().got, -101);
    EXPECT_FALSE(driver.block().run);
}

TEST_F(RobotDriverTest, TakesAHeldInputOnlyAfterItHasBeenAtZero) {
    EXPECT_EQ(set(kAll(5), true).error().code, Errc::MustPassZero);
    EXPECT_FALSE(driver.block().run);
    ASSERT_TRUE(set(kAll(0), true));
    EXPECT_TRUE(set(kAll(5), true));
    driver.halt();
    EXPECT_EQ(set(kAll(5), true).error().code, Errc::MustPassZero);
    EXPECT_TRUE(set(kAll(5), false)) << "what is not held counts at once";
}

TEST_F(RobotDriverTest, BrakesAtOnceAndKeepsTheRest) {
    driver.setDribbler(true);
    driver.armHighVoltage(true);
    driver.setCharger(true);
    ASSERT_TRUE(set(kAll(100)));
    pass(1s);
    driver.brake();
    wire::DriveBlock expected;
    expected.dribble = true;
    expected.charge = true;
    EXPECT_EQ(driver.block(), expected);
}

TEST_F(RobotDriverTest, DisarmingSwitchesOffWhatNeedsIt) {
    driver.armHighVoltage(true);
    driver.setCharger(true);
    driver.setAutokick(true, {true, true, 10, 0, 0});
    EXPECT_TRUE(driver.block().autokickArmed);
    driver.armHighVoltage(false);
    EXPECT_EQ(driver.block(), wire::brakedBlock());
}

TEST_F(RobotDriverTest, DischargingSwitchesChargerAndAutokickOff) {
    driver.armHighVoltage(true);
    driver.setCharger(true);
    driver.setAutokick(true, {true, true, 10, 0, 0});
    driver.setDischarging(true);
    EXPECT_EQ(driver.block(), wire::brakedBlock());
    EXPECT_TRUE(driver.intent().active());
}

TEST_F(RobotDriverTest, ALowerLimitHoldsForWhatRunsAlready) {
    ASSERT_TRUE(driver.setWheels(kAll(-800), false, 1023, now));
    driver.advance(now, false);
    EXPECT_TRUE(driver.clampTo(100));
    driver.advance(now, true);
    EXPECT_EQ(speed(), -100);
    EXPECT_FALSE(driver.clampTo(100));
}

}  // namespace
}  // namespace kickstand::thunderbots
