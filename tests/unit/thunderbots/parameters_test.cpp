#include "core/thunderbots/parameters.h"

#include <gtest/gtest.h>

namespace kickstand::thunderbots {
namespace {

constexpr wire::Channels kDongle{14, 15};

wire::OperationalParameters blockOf(std::uint8_t number) {
    wire::OperationalParameters block;
    block.flashContents = 0;
    block.channel0 = 14;
    block.channel1 = 15;
    block.robotNumber = number;
    block.dribblerDuty = 120;
    return block;
}

std::vector<ParameterRisk> risksOf(const wire::OperationalParameters& block, RobotMask alive = 0x0008) {
    std::vector<ParameterRisk> risks;
    for (const auto& warning : parameterWarnings(3, block, blockOf(3), kDongle, alive))
        risks.push_back(warning.risk);
    return risks;
}

TEST(Parameters, EveryFieldIsWhereItsNameSays) {
    for (const ParameterField field : kParameterFields) {
        EXPECT_EQ(parameterFieldFromName(name(field)), field);
        wire::OperationalParameters block;
        setValue(block, field, 99);
        EXPECT_EQ(valueOf(block, field), 99);
        EXPECT_EQ(wire::encodeParameters(block)[static_cast<std::size_t>(field)], 99) << name(field);
    }
    EXPECT_FALSE(parameterFieldFromName("tail").has_value());
}

TEST(Parameters, AFieldTakesWhatTheWireTakes) {
    for (const ParameterField field : kParameterFields) {
        for (int value = 0; value <= 255; ++value) {
            wire::OperationalParameters block = blockOf(3);
            setValue(block, field, static_cast<std::uint8_t>(value));
            EXPECT_EQ(checkParameter(field, value).has_value(), wire::checkParameters(block).has_value())
                << name(field) << ' ' << value;
        }
        EXPECT_FALSE(checkParameter(field, -1).has_value());
        EXPECT_FALSE(checkParameter(field, 256).has_value());
    }
}

TEST(Parameters, WhatAPersonWritesIsUnderstood) {
    EXPECT_EQ(parseParameter(ParameterField::Channel0, "0x0B").value(), 11);
    EXPECT_EQ(parseParameter(ParameterField::Channel0, "26").value(), 26);
    EXPECT_EQ(parseParameter(ParameterField::Channel1, "none").value(), 0);
    EXPECT_EQ(parseParameter(ParameterField::DribblerDuty, "100%").value(), 255);
    EXPECT_EQ(parseParameter(ParameterField::DribblerDuty, "50 %").value(), 128);
    EXPECT_EQ(parseParameter(ParameterField::DribblerDuty, "0xff").value(), 255);
    EXPECT_EQ(parseParameter(ParameterField::FlashContents, "microcontroller").value(), 1);
    EXPECT_EQ(parseParameter(ParameterField::FlashContents, "no-data").value(), 0xFF);
    for (const char* text :
         {"", " ", "x", "0x", "0x-3", "1.5", "101%", "-1%", "nan%", "1e1%", "12 ", "none "})
        EXPECT_FALSE(parseParameter(ParameterField::DribblerDuty, text).has_value()) << text;
    EXPECT_EQ(parseParameter(ParameterField::Channel0, "10").error().code, Errc::OutOfRange);
    EXPECT_EQ(parseParameter(ParameterField::Channel0, "fpga").error().code, Errc::Malformed);
    EXPECT_EQ(parseParameter(ParameterField::RobotNumber, "99999999999").error().code, Errc::Malformed);
}

TEST(Parameters, EveryPercentageIsTheNearestDutyAndComesBack) {
    for (int percent = 0; percent <= 100; ++percent)
        EXPECT_NEAR(dutyPercent(dutyOfPercent(percent)), percent, 0.2) << percent;
}

TEST(Parameters, DifferencesAreFoundFieldByField) {
    EXPECT_EQ(differences(blockOf(3), blockOf(3)), 0);
    EXPECT_EQ(differences(blockOf(3), blockOf(4)), maskOf(ParameterField::RobotNumber));
}

TEST(ParameterWarnings, AHarmlessChangeHasNone) {
    wire::OperationalParameters block = blockOf(3);
    block.dribblerDuty = 200;
    EXPECT_TRUE(risksOf(block).empty());
}

TEST(ParameterWarnings, ChannelsThatTheDongleDoesNotUseLoseTheRobot) {
    wire::OperationalParameters block = blockOf(3);
    block.channel1 = 16;
    EXPECT_EQ(risksOf(block), std::vector{ParameterRisk::OtherChannels});
    EXPECT_TRUE(parameterWarnings(3, block, blockOf(3), kDongle, 8).front().serious());
    EXPECT_TRUE(parameterWarnings(3, block, blockOf(3), std::nullopt, 8).empty())
        << "a cable has no channels";
    block.channel1 = 0;
    EXPECT_EQ(risksOf(block), std::vector{ParameterRisk::NoChannel});
    EXPECT_EQ(parameterWarnings(3, block, blockOf(3), std::nullopt, 8).front().risk,
              ParameterRisk::NoChannel);
}

TEST(ParameterWarnings, ANumberIsWorseWhenItIsTaken) {
    EXPECT_EQ(risksOf(blockOf(7)), std::vector{ParameterRisk::NumberChanges});
    EXPECT_FALSE(parameterWarnings(3, blockOf(7), blockOf(3), kDongle, 8).front().serious());
    EXPECT_EQ(risksOf(blockOf(7), 0x0088), std::vector{ParameterRisk::NumberTaken});
    EXPECT_TRUE(parameterWarnings(3, blockOf(7), blockOf(3), kDongle, 0x88).front().serious());
}

TEST(ParameterWarnings, WhatARobotHasAlreadyIsWeighedAgainstTheWorldAndNotAgainstItself) {
    // It was applied before, and is about to be committed.
    EXPECT_EQ(parameterWarnings(3, blockOf(7), blockOf(7), kDongle, 0x88).front().risk,
              ParameterRisk::NumberTaken);
}

TEST(ParameterWarnings, FlashContentsMeanWhatTheNextBootDoes) {
    wire::OperationalParameters block = blockOf(3);
    block.flashContents = 1;
    EXPECT_EQ(risksOf(block), std::vector{ParameterRisk::CopiesFlash});
    block.flashContents = 9;
    EXPECT_EQ(risksOf(block), std::vector{ParameterRisk::NoBitstream});
    EXPECT_TRUE(parameterWarnings(3, block, block, kDongle, 8).empty()) << "it is so already";
    const auto back = parameterWarnings(3, blockOf(3), block, kDongle, 8);
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(back.front().risk, ParameterRisk::OtherBitstream);
}

TEST(ParameterWarnings, TheGravestComesFirst) {
    wire::OperationalParameters block = blockOf(7);
    block.flashContents = 1;
    block.channel0 = 11;
    EXPECT_EQ(risksOf(block), (std::vector{ParameterRisk::CopiesFlash, ParameterRisk::OtherChannels,
                                           ParameterRisk::NumberChanges}));
}

}  // namespace
}  // namespace kickstand::thunderbots
