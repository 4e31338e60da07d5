#include <chrono>

#include <gtest/gtest.h>

#include "core/thunderbots/sim/sim_options.h"

namespace kickstand::thunderbots::sim {
namespace {

using namespace std::chrono_literals;

Result<ThunderbotsSimOptions> parse(std::map<std::string, std::string> options) {
    return parseSimOptions({.scheme = "sim", .target = "thunderbots", .options = std::move(options)});
}

TEST(SimOptions, WithoutAnyThereAreSixteenRobotsAtTheTruePace) {
    const auto options = parse({});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->robots, 0xFFFF);
    EXPECT_EQ(options->pace, RadioPace::True);
    EXPECT_EQ(options->weather.loss, 0);
    EXPECT_FALSE(options->cableRobot);
}

TEST(SimOptions, AllOfThem) {
    const auto options = parse({{"robots", "0-2,7,15"},
                                {"loss", "0.02"},
                                {"duplicate", "1"},
                                {"delay_ms", "5"},
                                {"seed", "42"},
                                {"radio", "ideal"},
                                {"noise", "off"}});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->robots, 0x8087);
    EXPECT_DOUBLE_EQ(options->weather.loss, 0.02);
    EXPECT_DOUBLE_EQ(options->weather.duplication, 1);
    EXPECT_EQ(options->weather.delay, 5ms);
    EXPECT_EQ(options->seed, 42U);
    EXPECT_EQ(options->pace, RadioPace::Ideal);
    EXPECT_FALSE(options->noise);
}

TEST(SimOptions, Cable) {
    const auto options = parse({{"cable", "3"}});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->cableRobot, 3);
    EXPECT_EQ(parse({{"cable", "3"}, {"robots", "3"}}).error().code, Errc::BadArgument);
}

TEST(SimOptions, AnUnknownOptionIsRefusedByName) {
    const auto options = parse({{"robot", "3"}});
    ASSERT_FALSE(options);
    EXPECT_EQ(options.error().code, Errc::UnknownName);
    EXPECT_EQ(options.error().subject, "robot");
}

struct Bad {
    const char* option;
    const char* text;
    Errc code;
};

class BadSimOption : public testing::TestWithParam<Bad> {};

TEST_P(BadSimOption, IsRefusedNamingTheOption) {
    const auto options = parse({{GetParam().option, GetParam().text}});
    ASSERT_FALSE(options);
    EXPECT_EQ(options.error().code, GetParam().code);
    EXPECT_EQ(options.error().subject, GetParam().option);
    if (GetParam().code == Errc::OutOfRange) {
        EXPECT_TRUE(options.error().lowest);
        EXPECT_TRUE(options.error().highest);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadSimOption,
    testing::Values(Bad{"robots", "", Errc::BadArgument}, Bad{"robots", "16", Errc::OutOfRange},
                    Bad{"robots", "-1", Errc::OutOfRange}, Bad{"robots", "5-3", Errc::OutOfRange},
                    Bad{"robots", "0-99", Errc::OutOfRange}, Bad{"robots", "1,,2", Errc::BadArgument},
                    Bad{"robots", "1-", Errc::BadArgument}, Bad{"robots", "a", Errc::BadArgument},
                    Bad{"robots", "99999999999999999999", Errc::BadArgument},
                    Bad{"cable", "16", Errc::OutOfRange}, Bad{"loss", "1.5", Errc::OutOfRange},
                    Bad{"loss", "-0.1", Errc::OutOfRange}, Bad{"loss", "nan", Errc::BadArgument},
                    Bad{"loss", "2%", Errc::BadArgument}, Bad{"duplicate", "", Errc::BadArgument},
                    Bad{"delay_ms", "5000", Errc::OutOfRange}, Bad{"seed", "-1", Errc::OutOfRange},
                    Bad{"radio", "fast", Errc::BadArgument}, Bad{"noise", "1", Errc::BadArgument}));

}  // namespace
}  // namespace kickstand::thunderbots::sim
