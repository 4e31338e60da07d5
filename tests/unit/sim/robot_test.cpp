#include <chrono>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/thunderbots/sim/robot_sim.h"
#include "core/thunderbots/wire/kick.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots::sim {
namespace {

using namespace std::chrono_literals;

class RobotTest : public testing::Test {
  protected:
    void drive(const wire::DriveBlock& block) { robot.takeDrive(wire::encodeDrive(block).value()); }
    /// Lets time pass with the block repeated, as a radio does.
    void driveFor(Duration span, const wire::DriveBlock& block) {
        for (Duration passed{}; passed < span; passed += 100ms) {
            drive(block);
            scheduler.advance(100ms);
        }
    }
    wire::FeedbackBlock feedback() { return wire::decodeFeedback(robot.feedback().value()).value(); }

    static wire::DriveBlock armed() {
        wire::DriveBlock block;
        block.autokickArmed = true;
        block.autokick = {.flag1 = true, .flag2 = true, .t1 = 75, .t2 = 0, .dt = 0};
        return block;
    }

    FakeScheduler scheduler;
    RobotSim robot{scheduler, {.number = 3, .battery_V = 16.0, .seed = 1, .noise = false}};
};

TEST_F(RobotTest, WithoutAFreshBlockForASecondEverythingGoesOff) {
    wire::DriveBlock block{.run = true, .charge = true, .dribble = true};
    block.wheels = {100, -100, 100, -100};
    driveFor(1s, block);
    scheduler.advance(899ms);
    RobotReport report = robot.report();
    EXPECT_TRUE(report.driveFresh);
    EXPECT_NEAR(report.wheelSpeeds[1], -100, 1);
    EXPECT_TRUE(report.charging);
    EXPECT_TRUE(report.dribbling);
    scheduler.advance(1ms);
    scheduler.advance(100ms);
    report = robot.report();
    EXPECT_FALSE(report.driveFresh);
    EXPECT_NEAR(report.wheelSpeeds[1], 0, 1);
    EXPECT_FALSE(report.charging);
    EXPECT_FALSE(report.dribbling);
    EXPECT_EQ(report.lastDrive, block);
}

TEST_F(RobotTest, TheTimeOutActsWhenItFallsDueHoweverLateSomebodyLooks) {
    driveFor(500ms, {.run = false, .charge = true});
    scheduler.advance(60s);
    // 1.4 s of charging, then nothing but a slow leak.
    EXPECT_GT(robot.report().capacitor_V, 100);
    EXPECT_LT(robot.report().capacitor_V, 150);
}

TEST_F(RobotTest, CountsWhatItWasTold) {
    wire::DriveBlock block{.run = true};
    block.wheels = {50, 0, 0, 0};
    driveFor(500ms, block);
    block.wheels = {60, 0, 0, 0};
    driveFor(500ms, block);
    scheduler.advance(5s);
    driveFor(200ms, block);
    robot.takeMessage(wire::Pipe::TestMode, wire::encodeTestMode({wire::TestClass::Hall, 5}).value());
    robot.takeMessage(wire::Pipe::TestMode, std::vector<std::uint8_t>{7, 0});
    const RobotReport report = robot.report();
    EXPECT_EQ(report.driveBlocks, 12U);
    EXPECT_EQ(report.driveChanges, 2U);
    EXPECT_EQ(report.driveTimeouts, 1U);
    EXPECT_EQ(report.testModeMessages, 1U);
    EXPECT_EQ(report.malformed, 1U);
}

TEST_F(RobotTest, ABlockThatTimedOutIsNotRefreshed) {
    wire::DriveBlock block{.run = true};
    block.wheels = {50, 0, 0, 0};
    drive(block);
    scheduler.advance(900ms);
    robot.refreshDrive();
    scheduler.advance(900ms);
    EXPECT_TRUE(robot.report().driveFresh);
    scheduler.advance(100ms);
    robot.refreshDrive();
    EXPECT_FALSE(robot.report().driveFresh);
    drive(block);
    EXPECT_TRUE(robot.report().driveFresh);
}

TEST_F(RobotTest, MeasuresWhatThereIs) {
    robot.setBattery(15.5);
    robot.setCapacitor(216);
    robot.setTemperature(40);
    robot.setBall(true);
    const wire::FeedbackBlock block = feedback();
    EXPECT_TRUE(block.valid);
    EXPECT_TRUE(block.ball);
    EXPECT_TRUE(block.charged);
    EXPECT_NEAR(wire::battery_V(block.battery_adc), 15.5, 0.02);
    EXPECT_NEAR(wire::capacitor_V(block.capacitor_adc), 216, 0.1);
    EXPECT_NEAR(wire::dribbler_C(block.thermistor_adc), 40, 0.6);
    EXPECT_GE(block.light_adc, wire::kBeamBall_adc);
    robot.setCapacitor(215);
    EXPECT_FALSE(feedback().charged);
}

TEST_F(RobotTest, KicksAsTheMessageSays) {
    robot.setCapacitor(219);
    robot.takeMessage(wire::Pipe::Kick,
                      wire::encodeKick({.flag1 = true, .t1 = 75, .t2 = 30, .dt = 20}).value());
    const RobotReport report = robot.report();
    ASSERT_EQ(report.kicks, 1U);
    const KickRecord& kick = report.lastKicks.back();
    EXPECT_EQ(kick.pulses[0], (wire::Pulse{.start_us = 0, .width_us = 2400}));
    EXPECT_EQ(kick.pulses[1], (wire::Pulse{.start_us = 640, .width_us = 320}));
    EXPECT_DOUBLE_EQ(kick.before_V, 219);
    EXPECT_LT(kick.after_V, 148);
    EXPECT_FALSE(kick.automatic);
}

TEST_F(RobotTest, AutokickFiresOnceABallAndSaysSo) {
    robot.setCapacitor(200);
    driveFor(200ms, armed());
    EXPECT_EQ(robot.report().kicks, 0U);
    robot.setBall(true);
    EXPECT_EQ(robot.report().automaticKicks, 1U);
    ASSERT_TRUE(robot.outgoing());
    EXPECT_EQ(robot.outgoing()->pipe, wire::Pipe::Indicator);
    EXPECT_TRUE(robot.outgoing()->payload.empty());
    driveFor(2s, armed());
    EXPECT_EQ(robot.report().automaticKicks, 1U);
    robot.setBall(false);
    driveFor(300ms, armed());
    robot.setBall(true);
    EXPECT_EQ(robot.report().automaticKicks, 2U);
}

TEST_F(RobotTest, ABallThatComesBackDuringTheLockOutIsKickedWhenItEnds) {
    driveFor(100ms, armed());
    robot.setBall(true);
    robot.setBall(false);
    driveFor(100ms, armed());
    robot.setBall(true);
    driveFor(100ms, armed());
    EXPECT_EQ(robot.report().automaticKicks, 1U);
    driveFor(100ms, armed());
    EXPECT_EQ(robot.report().automaticKicks, 2U);
}

TEST_F(RobotTest, AutokickNeedsToBeArmedFreshAndNotAllZero) {
    robot.setBall(true);
    wire::DriveBlock block = armed();
    block.autokick = {.flag1 = true, .flag2 = true};
    drive(block);
    block = armed();
    block.autokickArmed = false;
    drive(block);
    EXPECT_EQ(robot.report().kicks, 0U);
    robot.setBall(false);
    drive(armed());
    scheduler.advance(1s);
    robot.setBall(true);
    EXPECT_EQ(robot.report().kicks, 0U);
    drive(armed());
    EXPECT_EQ(robot.report().kicks, 1U);
}

TEST_F(RobotTest, ALowBatteryLocksItOutUntilItIsSwitchedOffAndOn) {
    robot.setBattery(12.9);
    scheduler.advance(900ms);
    EXPECT_TRUE(robot.feedback());
    scheduler.advance(200ms);
    EXPECT_FALSE(robot.feedback());
    EXPECT_EQ(robot.report().power, RobotPower::LockedOut);
    robot.setBattery(16);
    scheduler.advance(10s);
    EXPECT_FALSE(robot.up());
    robot.switchPower(true);
    scheduler.advance(3s);
    EXPECT_TRUE(robot.up());
    EXPECT_EQ(robot.boots(), 2U);
}

TEST_F(RobotTest, TestModeOfTheDriveBlockGoesBeforeTheMessage) {
    robot.takeMessage(wire::Pipe::TestMode,
                      wire::encodeTestMode({.testClass = wire::TestClass::Lamp}).value());
    EXPECT_EQ(robot.report().leds, 0b1111);
    wire::DriveBlock block{.testClass = 4, .testTarget = 2};
    drive(block);
    EXPECT_EQ(robot.report().testMode,
              (wire::TestMode{.testClass = wire::TestClass::EncoderCount, .target = 2}));
    scheduler.advance(1s);
    EXPECT_EQ(robot.report().testMode.testClass, wire::TestClass::Lamp);
    block.testClass = 7;
    drive(block);
    EXPECT_EQ(robot.report().leds, 0);
}

TEST_F(RobotTest, WhatMakesNoSenseIsCountedAndChangesNothing) {
    wire::DriveBlock block{.run = true};
    drive(block);
    auto bytes = wire::encodeDrive(block).value();
    bytes[1] = 0x80;
    bytes[2] = 0x00;
    robot.takeDrive(bytes);
    robot.takeDrive(ByteView(bytes).first(9));
    const std::array<std::uint8_t, 5> five{99, 1, 2, 3, 4};
    robot.takeMessage(wire::Pipe::Kick, five);
    robot.takeMessage(wire::Pipe::TestMode, five);
    robot.takeMessage(wire::Pipe::FirmwareRequest, five);
    robot.takeMessage(wire::Pipe::FirmwareRequest, {});
    robot.takeMessage(wire::Pipe::Indicator, five);
    const RobotReport report = robot.report();
    EXPECT_EQ(report.malformed, 7U);
    EXPECT_EQ(report.lastDrive, block);
    EXPECT_EQ(report.kicks, 0U);
}

TEST_F(RobotTest, SwitchedOffItKeepsNothingButItsFlashAndCapacitor) {
    robot.setCapacitor(200);
    drive({.run = true, .charge = true});
    robot.switchPower(false);
    EXPECT_FALSE(robot.feedback());
    robot.takeMessage(wire::Pipe::Kick, wire::encodeKick({.t1 = 75}).value());
    scheduler.advance(10s);
    EXPECT_GT(robot.report().capacitor_V, 190);
    EXPECT_EQ(robot.report().kicks, 0U);
    robot.switchPower(true);
    EXPECT_EQ(robot.report().power, RobotPower::Booting);
    scheduler.advance(3s);
    EXPECT_FALSE(feedback().valid);
    scheduler.advance(100ms);
    EXPECT_TRUE(feedback().valid);
    EXPECT_FALSE(robot.report().driveFresh);
}

TEST_F(RobotTest, LookingOftenOrSeldomGivesTheSameRobot) {
    RobotSim other{scheduler, {.number = 3, .battery_V = 16.0, .seed = 1, .noise = false}};
    const wire::DriveBlock block{
        .run = true, .charge = true, .dribble = true, .wheels = {200, 100, -100, -200}};
    for (int i = 0; i < 500; ++i) {
        drive(block);
        other.takeDrive(wire::encodeDrive(block).value());
        scheduler.advance(5ms);
        other.feedback();
    }
    EXPECT_NEAR(robot.report().battery_V, other.report().battery_V, 0.01);
    EXPECT_NEAR(robot.report().capacitor_V, other.report().capacitor_V, 0.1);
    EXPECT_NEAR(static_cast<double>(robot.report().wheelCounts[0]),
                static_cast<double>(other.report().wheelCounts[0]), 2);
}

}  // namespace
}  // namespace kickstand::thunderbots::sim
