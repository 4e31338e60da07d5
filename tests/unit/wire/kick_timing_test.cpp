#include "core/thunderbots/wire/kick_timing.h"

#include <climits>
#include <cstdlib>

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;
using Reason = KickTimingError::Reason;

void expectSent(const KickPulses& asked, const KickPulses& sent, std::string_view bytes) {
    const auto encoding = encodePulses(asked);
    ASSERT_TRUE(encoding.has_value());
    EXPECT_EQ(encoding->sent, sent);
    EXPECT_EQ(encoding->snapped, sent != asked);
    EXPECT_EQ(bytesOf(encodeKick(encoding->times).value()), hex(bytes));
    EXPECT_EQ(personTermsOf(encoding->times), sent);
}

void expectRefused(const KickPulses& asked, Reason reason, int solenoid, std::int64_t at,
                   std::int64_t excess) {
    const auto encoding = encodePulses(asked);
    ASSERT_FALSE(encoding.has_value());
    EXPECT_EQ(encoding.error().reason, reason);
    EXPECT_EQ(encoding.error().solenoid, solenoid);
    EXPECT_EQ(encoding.error().at_us, at);
    EXPECT_EQ(encoding.error().excess_us, excess);
}

TEST(KickTiming, SpecificationVectors) {
    expectSent({2400, 0, 0}, {2400, 0, 0}, "cb 80 00");
    expectSent({2016, 1024, 320}, {2016, 1024, 320}, "bf 2a 0a");
}

TEST(KickTiming, ANegativeOffsetDelaysSolenoid1) {
    expectSent({1024, 2016, -320}, {1024, 2016, -320}, "2a bf 0a");
}

TEST(KickTiming, EqualStartsSetBothFlags) {
    expectSent({320, 640, 0}, {320, 640, 0}, "8a 94 00");
}

TEST(KickTiming, TheLastStepIsReachedAndNotPassed) {
    expectSent({4064, 0, 0}, {4064, 0, 0}, "ff 80 00");
    expectSent({0, 4064, 0}, {0, 4064, 0}, "80 ff 00");
    expectSent({4064, 4064, 0}, {4064, 4064, 0}, "ff ff 00");
    expectSent({32, 32, 4032}, {32, 32, 4032}, "81 7f 7e");
    expectSent({32, 32, -4032}, {32, 32, -4032}, "7f 81 7e");
    expectRefused({4065, 0, 0}, Reason::EdgeTooLate, 1, 4065, 1);
    expectRefused({0, 4096, 0}, Reason::EdgeTooLate, 2, 4096, 32);
    expectRefused({32, 33, 4032}, Reason::EdgeTooLate, 2, 4065, 1);
    expectRefused({33, 32, -4032}, Reason::EdgeTooLate, 1, 4065, 1);
}

TEST(KickTiming, ValuesOffTheGridGoToTheNearestStepHalfWayTowardsZero) {
    expectSent({2401, 0, 0}, {2400, 0, 0}, "cb 80 00");
    expectSent({2416, 0, 0}, {2400, 0, 0}, "cb 80 00");
    expectSent({2417, 0, 0}, {2432, 0, 0}, "cc 80 00");
    expectSent({320, 320, 16}, {320, 320, 0}, "8a 8a 00");
    expectSent({320, 320, 17}, {320, 320, 32}, "8a 0b 01");
    expectSent({320, 320, -16}, {320, 320, 0}, "8a 8a 00");
    expectSent({320, 320, -17}, {320, 320, -32}, "0b 8a 01");
}

TEST(KickTiming, WithoutASecondPulseThereIsNoOffset) {
    expectSent({0, 1024, 320}, {0, 1024, 0}, "80 a0 00");
    expectSent({1024, 0, -4000}, {1024, 0, 0}, "a0 80 00");
    expectSent({16, 1024, 320}, {0, 1024, 0}, "80 a0 00");
    expectSent({0, 0, 320}, {0, 0, 0}, "80 80 00");
}

TEST(KickTiming, NegativeWidthsAreRefused) {
    expectRefused({-1, 0, 0}, Reason::NegativeWidth, 1, -1, 0);
    expectRefused({0, -32, 0}, Reason::NegativeWidth, 2, -32, 0);
}

TEST(KickTiming, AbsurdNumbersAreRefusedWithoutOverflow) {
    expectRefused({INT_MAX, INT_MAX, INT_MAX}, Reason::EdgeTooLate, 1, INT_MAX, INT_MAX - 4064LL);
    expectRefused({100, 100, INT_MIN}, Reason::EdgeTooLate, 1, 100 - static_cast<std::int64_t>(INT_MIN),
                  100 - static_cast<std::int64_t>(INT_MIN) - 4064);
    expectRefused({INT_MIN, 0, 0}, Reason::NegativeWidth, 1, INT_MIN, 0);
}

/// What matters of two pulses: how wide they are, and how far apart they begin where both exist.
KickPulses shapeOf(const std::array<Pulse, 2>& pulses) {
    const bool both = pulses[0].width_us > 0 && pulses[1].width_us > 0;
    return {pulses[0].width_us, pulses[1].width_us, both ? pulses[1].start_us - pulses[0].start_us : 0};
}

TEST(KickTiming, EveryKickOfTheWireHasPersonsTermsThatEncodeToTheSamePulses) {
    for (int flags = 0; flags < 4; ++flags) {
        for (int t1 = 0; t1 <= kKickMaxSteps; ++t1) {
            for (int t2 = 0; t2 <= kKickMaxSteps; ++t2) {
                for (int dt = 0; dt <= kKickMaxSteps; ++dt) {
                    const KickTimes times{(flags & 1) != 0, (flags & 2) != 0, static_cast<std::uint8_t>(t1),
                                          static_cast<std::uint8_t>(t2), static_cast<std::uint8_t>(dt)};
                    const KickPulses terms = personTermsOf(times);
                    const auto encoding = encodePulses(terms);
                    if (!encoding || encoding->snapped || encoding->sent != terms ||
                        shapeOf(pulsesOf(encoding->times)) != shapeOf(pulsesOf(times))) {
                        FAIL() << flags << ' ' << t1 << ' ' << t2 << ' ' << dt;
                    }
                }
            }
        }
    }
}

TEST(KickTiming, EverythingAPersonCanAskForIsSentExactlySnappedOrRefused) {
    const auto near = [](int asked, int sent) { return sent % 32 == 0 && std::abs(asked - sent) <= 16; };
    std::mt19937 random(4);
    for (int i = 0; i < 400'000; ++i) {
        const KickPulses asked{between(random, 0, 4300), between(random, 0, 4300),
                               between(random, -4300, 4300)};
        const auto encoding = encodePulses(asked);
        const bool both = asked.width1_us > 16 && asked.width2_us > 16;
        const int delay1 = both && asked.offset_us < 0 ? -asked.offset_us : 0;
        const int delay2 = both && asked.offset_us > 0 ? asked.offset_us : 0;
        const bool fits = delay1 + asked.width1_us <= kKickMax_us && delay2 + asked.width2_us <= kKickMax_us;
        ASSERT_EQ(encoding.has_value(), fits)
            << asked.width1_us << ' ' << asked.width2_us << ' ' << asked.offset_us;
        if (!fits) continue;
        ASSERT_TRUE(near(asked.width1_us, encoding->sent.width1_us));
        ASSERT_TRUE(near(asked.width2_us, encoding->sent.width2_us));
        ASSERT_TRUE(near(both ? asked.offset_us : 0, encoding->sent.offset_us));
        ASSERT_TRUE(encodeKick(encoding->times).has_value());
    }
}

TEST(KickTiming, PulsesAreDrawnWhereTheRobotPutsThem) {
    const auto late = pulsesOf({false, false, 20, 5, 10});
    EXPECT_EQ(late[0], (Pulse{320, 320}));
    EXPECT_EQ(late[1], (Pulse{})) << "its end lies before its begin";
    const auto apart = pulsesOf({true, false, 63, 42, 10});
    EXPECT_EQ(apart[0], (Pulse{0, 2016}));
    EXPECT_EQ(apart[1], (Pulse{320, 1024}));
}

TEST(KickTiming, ErrorsTellTheEdgeToTheOutside) {
    const Error late = toError(encodePulses({32, 4064, 320}).error());
    EXPECT_EQ(late.code, Errc::NoEncoding);
    EXPECT_EQ(late.subject, "solenoid 2");
    EXPECT_EQ(late.highest, 4064);
    EXPECT_EQ(late.got, 4384);
    EXPECT_EQ(toError(encodePulses({-5, 0, 0}).error()).code, Errc::OutOfRange);
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
