#include "core/thunderbots/discharger.h"

#include <gtest/gtest.h>

#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;
using Finding = Discharger::Finding;

RobotState at(double volts, Freshness freshness = Freshness::Current) {
    RobotState state;
    state.freshness = freshness;
    state.readings.capacitor_V = volts;
    return state;
}

TEST(Discharger, PulsesForNinetySixMicrosecondsOnOneSolenoid) {
    const auto pulses = wire::personTermsOf(Discharger::kPulse);
    EXPECT_EQ(pulses.width1_us, 96);
    EXPECT_EQ(pulses.width2_us, 0);
}

TEST(Discharger, PulsesAgainAndAgainUntilTwentyFiveVolts) {
    Discharger discharger;
    TimePoint now{1s};
    discharger.begin(3, 200, now);
    double volts = 200;
    int pulses = 0;
    for (; pulses < 1000 && volts > 25; ++pulses) {
        ASSERT_EQ(discharger.look(3, at(volts), now), Finding::Pulse);
        discharger.pulsed(3, now);
        EXPECT_EQ(discharger.look(3, at(volts), now), Finding::Wait);
        now += 50ms;
        volts -= 1;
    }
    EXPECT_EQ(discharger.look(3, at(volts), now), Finding::Empty);
    EXPECT_EQ(pulses, 175);
}

TEST(Discharger, SaysWhenPulsesHaveNoEffect) {
    Discharger discharger;
    TimePoint now{};
    discharger.begin(0, 100, now);
    Finding finding = Finding::Pulse;
    int pulses = 0;
    for (; finding == Finding::Pulse && pulses < 1000; ++pulses) {
        discharger.pulsed(0, now);
        now += 50ms;
        finding = discharger.look(0, at(100), now);
    }
    EXPECT_EQ(finding, Finding::NoEffect);
}

TEST(Discharger, StopsWhenNobodyKnowsTheVoltage) {
    Discharger discharger;
    discharger.begin(0, 100, TimePoint{});
    for (const Freshness freshness : {Freshness::NotHeard, Freshness::Waiting, Freshness::Stale})
        EXPECT_EQ(discharger.look(0, at(100, freshness), TimePoint{}), Finding::Unknown);
}

TEST(Discharger, KeepsRobotsApart) {
    Discharger discharger;
    discharger.begin(1, 100, TimePoint{});
    EXPECT_TRUE(discharger.running(1));
    EXPECT_FALSE(discharger.running(2));
    EXPECT_EQ(discharger.look(2, at(100), TimePoint{}), Finding::Wait);
    discharger.end(1);
    EXPECT_FALSE(discharger.running(1));
}

}  // namespace
}  // namespace kickstand::thunderbots
