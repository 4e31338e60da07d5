#include "app/kickstandctl/values.h"

#include <gtest/gtest.h>

namespace kickstand::ctl {
namespace {

using thunderbots::RobotMask;
using thunderbots::WheelSpeeds;

TEST(Values, WholeNumbersAreTakenWholeOrNotAtAll) {
    EXPECT_EQ(parseWhole("42", "--x", 0, 100), 42);
    EXPECT_EQ(parseWhole("-42", "--x", -100, 100), -42);
    EXPECT_EQ(parseWhole("0x1A", "--x", 0, 100), 26);
    EXPECT_EQ(parseWhole("-0x10", "--x", -100, 100), -16);
    for (const char* text : {"", " ", "-", "--1", "+1", "1 ", " 1", "1.0", "1e2", "0x", "0x-1", "x", "1a",
                             "１", "101", "-1", "99999999999999999999", "-99999999999999999999"})
        EXPECT_FALSE(parseWhole(text, "--x", 0, 100)) << text;
}

TEST(Values, DecimalsHaveAPointInEveryCountry) {
    EXPECT_EQ(parseDecimal("1.5", "--x", 0, 10), 1.5);
    EXPECT_EQ(parseDecimal("10", "--x", 0, 10), 10);
    for (const char* text : {"", "1,5", "1.5s", "nan", "inf", "-inf", "1e99", " 1", "0x1p3", "-0.1", "10.01"})
        EXPECT_FALSE(parseDecimal(text, "--x", 0, 10)) << text;
}

TEST(Values, SecondsAreBounded) {
    EXPECT_EQ(parseSeconds("0.25", "--for"), std::chrono::milliseconds(250));
    EXPECT_EQ(parseSeconds("86400", "--for"), std::chrono::hours(24));
    for (const char* text : {"0", "0.001", "-1", "86401", "1e300"})
        EXPECT_FALSE(parseSeconds(text, "--for")) << text;
}

TEST(Values, RobotsOneByOneAndInRanges) {
    EXPECT_EQ(parseRobots("3"), RobotMask{0x0008});
    EXPECT_EQ(parseRobots("0,15"), RobotMask{0x8001});
    EXPECT_EQ(parseRobots("5-7"), RobotMask{0x00E0});
    EXPECT_EQ(parseRobots("0-15"), RobotMask{0xFFFF});
    EXPECT_EQ(parseRobots("0,3,5-7,3"), RobotMask{0x00E9});
    for (const char* text :
         {"", ",", "3,", "16", "-1", "7-5", "1-", "-", "1-2-3", "all", "0-16", "1;2", "0-99999999999"})
        EXPECT_FALSE(parseRobots(text)) << text;
}

TEST(Values, WheelsWithinTheLimit) {
    EXPECT_EQ(parseWheels("1,-2,0x10,100", 100), (WheelSpeeds{1, -2, 16, 100}));
    EXPECT_EQ(parseWheels("1023,-1023,0,0", 1023), (WheelSpeeds{1023, -1023, 0, 0}));
    for (const char* text :
         {"", "1,2,3", "1,2,3,4,5", "1,2,3,", "a,b,c,d", "101,0,0,0", "0,0,0,-101", "1 ,2,3,4"})
        EXPECT_FALSE(parseWheels(text, 100)) << text;
    EXPECT_FALSE(parseWheels("-1024,0,0,0", 1023));
}

TEST(Values, MistakesAreBadUsageAndNameWhatWasTyped) {
    const auto wrong = parseWhole("seven", "--limit", 0, 9);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().exitCode, kBadUsage);
    EXPECT_EQ(wrong.error().text.line().toStdString(),
              "--limit cannot be “seven”. It is a whole number from 0 to 9.");
}

}  // namespace
}  // namespace kickstand::ctl
