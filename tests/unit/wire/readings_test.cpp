#include "core/thunderbots/wire/readings.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace kickstand::thunderbots::wire {
namespace {

TEST(Readings, FollowTheFormulasOfTheReference) {
    for (const int adc : {0, 1, 200, 511, 1023}) {
        const auto raw = static_cast<std::uint16_t>(adc);
        EXPECT_NEAR(battery_V(raw), (adc + 0.5) / 1024 * 3.3 / 330 * 1830, 1e-9);
        EXPECT_NEAR(dribbler_C(raw), adc * 0.5735 - 205.9815, 1e-9);
    }
    for (const int adc : {0, 1, 2048, 4095}) {
        EXPECT_NEAR(capacitor_V(static_cast<std::uint16_t>(adc)), adc / 4096.0 * 3.3 / 2200 * 222200, 1e-9);
    }
}

TEST(Readings, EveryReadingComesBackFromItsVoltsOrDegrees) {
    for (std::uint16_t adc = 0; adc <= kMaxAdc10; ++adc) {
        ASSERT_EQ(battery_adc(battery_V(adc)), adc);
        ASSERT_EQ(thermistor_adc(dribbler_C(adc)), adc);
    }
    for (std::uint16_t adc = 0; adc <= kMaxAdc12; ++adc)
        ASSERT_EQ(capacitor_adc(capacitor_V(adc)), adc);
}

TEST(Readings, WhatAConverterCannotShowGivesItsEnd) {
    EXPECT_EQ(battery_adc(-1), 0);
    EXPECT_EQ(battery_adc(1000), kMaxAdc10);
    EXPECT_EQ(capacitor_adc(-0.1), 0);
    EXPECT_EQ(capacitor_adc(1e12), kMaxAdc12);
    EXPECT_EQ(thermistor_adc(-273), 0);
    EXPECT_EQ(thermistor_adc(std::numeric_limits<double>::infinity()), kMaxAdc10);
    EXPECT_EQ(thermistor_adc(std::nan("")), 0);
}

TEST(Readings, ThresholdsLieWithinWhatCanBeMeasured) {
    EXPECT_LT(kCapacitorDischarged_V, kCapacitorLive_V);
    EXPECT_LT(kCapacitorLive_V, kCapacitorCharged_V);
    EXPECT_LT(kCapacitorCharged_V, capacitor_V(kMaxAdc12));
    EXPECT_LT(kBatteryLockOut_V, kBatteryEmpty_V);
    EXPECT_LT(kBatteryEmpty_V, kBatteryLow_V);
    EXPECT_LT(kBatteryLow_V, battery_V(kMaxAdc10));
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
