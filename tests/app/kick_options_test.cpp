#include "app/kickstandctl/kick_options.h"

#include <gtest/gtest.h>

namespace kickstand::ctl {
namespace {

Invocation with(std::map<std::string, std::string, std::less<>> options) {
    Invocation invocation;
    invocation.options = std::move(options);
    return invocation;
}

TEST(KickOptions, GiveTheWiresTimes) {
    const auto kick = readKick(with({{"--width1", "2016"}, {"--width2", "1024"}, {"--offset", "320"}}));
    ASSERT_TRUE(kick);
    EXPECT_EQ(kick->times.t1, 63);
    EXPECT_EQ(kick->times.t2, 42);
    EXPECT_EQ(kick->times.dt, 10);
    EXPECT_FALSE(kick->snapped);
    EXPECT_EQ(kickText(*kick).toStdString(), "2016 / 1024 µs, solenoid 2 later by 320 µs");
}

TEST(KickOptions, SayWhenTheySnap) {
    const auto kick = readKick(with({{"--width1", "2390"}}));
    ASSERT_TRUE(kick);
    EXPECT_EQ(kickToJson(*kick)[QStringLiteral("width1_us")].toInt(), 2400);
    EXPECT_TRUE(kickToJson(*kick)[QStringLiteral("snapped")].toBool());
    EXPECT_TRUE(kickText(*kick).contains(QStringLiteral("grid of 32 µs")));
}

TEST(KickOptions, RefuseWhatDoesNothingOrDoesNotFit) {
    EXPECT_FALSE(readKick(with({})));
    EXPECT_FALSE(readKick(with({{"--width1", "0"}, {"--width2", "0"}})));
    EXPECT_FALSE(readKick(with({{"--width1", "7"}})));
    EXPECT_FALSE(readKick(with({{"--width1", "4065"}})));
    EXPECT_FALSE(readKick(with({{"--width1", "100"}, {"--width2", "4064"}, {"--offset", "64"}})));
    EXPECT_FALSE(readKick(with({{"--width1", "x"}})));
    EXPECT_TRUE(readKick(with({{"--width1", "4064"}})));
    EXPECT_EQ(readKick(with({{"--width1", "4065"}})).error().exitCode, kBadUsage);
}

}  // namespace
}  // namespace kickstand::ctl
