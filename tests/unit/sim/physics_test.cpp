#include <bit>
#include <chrono>
#include <set>

#include <gtest/gtest.h>

#include "core/thunderbots/sim/break_beam.h"
#include "core/thunderbots/sim/robot_body.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots::sim {
namespace {

using namespace std::chrono_literals;

TEST(Battery, GivesWayUnderLoadAndComesBack) {
    Battery battery(16.0);
    battery.step(1s, 5.0);
    EXPECT_LT(battery.terminal_V(), 15.8);
    EXPECT_GT(battery.terminal_V(), 15.0);
    battery.step(1s, 0);
    EXPECT_DOUBLE_EQ(battery.terminal_V(), 16.0);
}

TEST(Battery, LocksOutAfterASecondBelowThirteenVoltsUntilSwitchedOff) {
    Battery battery(12.9);
    battery.step(999ms, 0);
    EXPECT_FALSE(battery.lockedOut());
    battery.step(1ms, 0);
    EXPECT_TRUE(battery.lockedOut());
    battery.setRest(16.0);
    battery.step(10s, 0);
    EXPECT_TRUE(battery.lockedOut());
    battery.switchOff();
    EXPECT_FALSE(battery.lockedOut());
}

TEST(Battery, AShortDipDoesNotLockOut) {
    Battery battery(13.2);
    battery.step(900ms, 5.0);
    EXPECT_LT(battery.terminal_V(), 13.0);
    battery.step(100ms, 0);
    battery.step(900ms, 5.0);
    EXPECT_FALSE(battery.lockedOut());
}

TEST(Capacitor, ChargesEverMoreSlowlyAndNeverPastFull) {
    Capacitor capacitor;
    double last_V = 0;
    double lastGain_V = 1e9;
    for (int i = 0; i < 34; ++i) {
        capacitor.step(100ms, true);
        const double gain_V = capacitor.volts() - last_V;
        EXPECT_GT(gain_V, 0) << i;
        EXPECT_LT(gain_V, lastGain_V) << i;
        last_V = capacitor.volts();
        lastGain_V = gain_V;
    }
    EXPECT_TRUE(capacitor.charged());
    capacitor.step(1s, true);
    EXPECT_LE(capacitor.volts(), Capacitor::kFull_V);
    EXPECT_FALSE(capacitor.charging());
    EXPECT_FALSE(capacitor.timedOut());
}

TEST(Capacitor, TheCurveDoesNotDependOnHowTimeIsCut) {
    Capacitor fine;
    Capacitor coarse;
    for (int i = 0; i < 2000; ++i)
        fine.step(1ms, true);
    coarse.step(2s, true);
    EXPECT_NEAR(fine.volts(), coarse.volts(), 0.2);
}

TEST(Capacitor, RegulatesForAsLongAsTheChargerIsOn) {
    Capacitor capacitor;
    capacitor.step(5s, true);
    for (int i = 0; i < 600; ++i) {
        capacitor.step(100ms, true);
        EXPECT_TRUE(capacitor.charged());
        EXPECT_LE(capacitor.volts(), Capacitor::kFull_V);
    }
    capacitor.step(1h, true);
    EXPECT_TRUE(capacitor.charged());
}

TEST(Capacitor, AFullKickTakesItFrom219To148VoltsAndItIsBackWithinTwoSeconds) {
    Capacitor capacitor;
    capacitor.set(219);
    capacitor.discharge(2400us, 2400us);
    EXPECT_NEAR(capacitor.volts(), 148, 0.5);
    capacitor.step(1890ms, true);
    EXPECT_TRUE(capacitor.charged());
}

TEST(Capacitor, ShortPulsesEmptyItMonotonically) {
    Capacitor capacitor;
    capacitor.set(219);
    int pulses = 0;
    while (capacitor.volts() > wire::kCapacitorDischarged_V && pulses < 1000) {
        const double before_V = capacitor.volts();
        capacitor.discharge(96us, 96us);
        capacitor.step(20ms, false);
        EXPECT_LT(capacitor.volts(), before_V);
        ++pulses;
    }
    EXPECT_GT(pulses, 50);
    EXPECT_LT(pulses, 300);
}

TEST(Capacitor, KeepsItsChargeForMinutesWhenTheChargerIsOff) {
    Capacitor capacitor;
    capacitor.set(212);
    capacitor.step(40s, false);
    EXPECT_GT(capacitor.volts(), wire::kCapacitorLive_V * 3);
    EXPECT_LT(capacitor.volts(), 212);
}

TEST(Capacitor, TheChargerRestsDuringAKickAndGivesUpOnABrokenBank) {
    Capacitor capacitor;
    capacitor.set(100);
    capacitor.discharge(1ms, 10ms);
    const double after_V = capacitor.volts();
    capacitor.step(10ms, true);
    EXPECT_LE(capacitor.volts(), after_V);
    for (int i = 0; i < 9; ++i) {
        capacitor.set(0);
        capacitor.step(1s, true);
    }
    EXPECT_TRUE(capacitor.timedOut());
    EXPECT_FALSE(capacitor.charging());
    capacitor.step(1ms, false);
    EXPECT_FALSE(capacitor.timedOut());
}

TEST(Motor, SpinsUpTowardsItsSetPointAndBrakesFaster) {
    Motor motor;
    motor.step(60ms, 100, true);
    EXPECT_NEAR(motor.speed(), 63, 1);
    motor.step(1s, 100, true);
    EXPECT_NEAR(motor.speed(), 100, 0.1);
    motor.step(60ms, 100, false);
    EXPECT_LT(motor.speed(), 6);
}

TEST(Motor, CountsQuarterDegreesOverAnyCutOfTime) {
    Motor motor;
    motor.step(10s, 100, true);
    const std::int64_t settled = motor.count();
    for (int i = 0; i < 100; ++i)
        motor.step(10ms, 100, true);
    EXPECT_NEAR(static_cast<double>(motor.count() - settled), 100 * 200, 2);
    motor.step(10s, -300, true);
    EXPECT_LT(motor.count(), 0);
}

TEST(Motor, ItsSensorsStepLikeRealOnes) {
    Motor motor;
    std::set<int> halls;
    std::uint8_t last = motor.encoderLines();
    std::int64_t lastCount = motor.count();
    for (int i = 0; i < 4000; ++i) {
        motor.step(1ms, 4, true);
        if (motor.count() == lastCount + 1) {
            EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(last ^ motor.encoderLines())));
        }
        last = motor.encoderLines();
        lastCount = motor.count();
        halls.insert(motor.hallLines());
    }
    EXPECT_EQ(halls, (std::set<int>{1, 2, 3, 4, 5, 6}));
}

TEST(Dribbler, HeatsUpUntilItsThermistorStopsIt) {
    Dribbler dribbler;
    dribbler.step(1s, true, 255);
    EXPECT_TRUE(dribbler.running());
    double last_C = dribbler.temperature_C();
    for (int i = 0; i < 60; ++i) {
        dribbler.step(1s, true, 255);
        EXPECT_GT(dribbler.temperature_C(), last_C);
        last_C = dribbler.temperature_C();
    }
    for (int i = 0; i < 600; ++i)
        dribbler.step(1s, true, 255);
    EXPECT_NEAR(dribbler.temperature_C(), wire::dribbler_C(wire::kThermistorHighest_adc), 2);
    dribbler.step(300s, false, 255);
    EXPECT_LT(dribbler.temperature_C(), 40);
}

TEST(Dribbler, RunsOnlyWithinItsThermistorsRange) {
    Dribbler dribbler;
    for (const int adc : {199, 200, 499, 500}) {
        dribbler.setTemperature(wire::dribbler_C(static_cast<std::uint16_t>(adc)));
        ASSERT_EQ(dribbler.thermistor_adc(), adc);
        dribbler.step(1ms, true, 100);
        EXPECT_EQ(dribbler.running(), adc >= 200 && adc <= 499) << adc;
    }
}

TEST(BreakBeam, ReadsPastTheThresholdWithABall) {
    BreakBeam beam;
    EXPECT_LT(beam.light_adc(), wire::kBeamBall_adc);
    beam.setBall(true, TimePoint{});
    EXPECT_GE(beam.light_adc(), wire::kBeamBall_adc);
}

TEST(BreakBeam, LockOutLastsUntil250MillisecondsAfterTheBeamClears) {
    BreakBeam beam;
    TimePoint now{};
    beam.setBall(true, now);
    beam.lockOut();
    now += 10s;
    EXPECT_TRUE(beam.lockedOut(now));
    beam.setBall(false, now);
    EXPECT_TRUE(beam.lockedOut(now + 249ms));
    EXPECT_FALSE(beam.lockedOut(now + 250ms));
}

TEST(TestLeds, ShowWhatTheirClassSays) {
    RobotBody body(16);
    BodyInputs inputs{.run = true};
    inputs.wheels = {500, 0, 0, 0};
    body.step(123ms, inputs);
    const auto leds = [&body](wire::TestClass testClass, std::uint8_t target) {
        return testLeds({.testClass = testClass, .target = target}, body);
    };
    EXPECT_EQ(leds(wire::TestClass::None, 0), 0);
    EXPECT_EQ(leds(wire::TestClass::Lamp, 0), 0b1111);
    EXPECT_EQ(leds(wire::TestClass::Hall, 1), body.wheels[0].hallLines());
    EXPECT_EQ(leds(wire::TestClass::Hall, 5), body.dribbler.motor().hallLines());
    EXPECT_EQ(leds(wire::TestClass::Encoder, 1), body.wheels[0].encoderLines());
    EXPECT_EQ(leds(wire::TestClass::EncoderCount, 1), body.wheels[0].count() & 15);
    EXPECT_NE(body.wheels[0].count(), body.wheels[1].count());
    for (const std::uint8_t target : std::initializer_list<std::uint8_t>{0, 6, 255}) {
        EXPECT_EQ(leds(wire::TestClass::Hall, target), 0);
        EXPECT_EQ(leds(wire::TestClass::Encoder, target), 0);
    }
    EXPECT_EQ(leds(wire::TestClass::EncoderCount, 5), 0);
}

TEST(TestLeds, TheChargersPulsesBlink) {
    RobotBody body(16);
    std::set<int> seen;
    for (int i = 0; i < 10; ++i) {
        body.step(100ms, {.charge = true});
        seen.insert(testLeds({.testClass = wire::TestClass::Charger}, body));
    }
    EXPECT_EQ(seen, (std::set<int>{0, 1}));
}

}  // namespace
}  // namespace kickstand::thunderbots::sim
