#include <gtest/gtest.h>

#include "core/engine/describe_parameter_file.h"

namespace kickstand {
namespace {

using thunderbots::ParameterField;
using thunderbots::ParameterValues;

QByteArray withFields(const char* fields) {
    return QByteArray(R"({"kickstand": "parameters", "version": 1, "parameters": )") + fields + "}";
}

Errc codeOf(const QByteArray& file) {
    const auto read = readParameterFile(file);
    EXPECT_FALSE(read.has_value()) << file.constData();
    return read ? Errc::Io : read.error().code;
}

TEST(ParameterFile, WhatIsWrittenReadsAsTheSame) {
    const ParameterValues all{std::uint8_t{1}, std::uint8_t{0}, std::uint8_t{26}, std::uint8_t{15},
                              std::uint8_t{255}};
    EXPECT_EQ(readParameterFile(writeParameterFile(all)).value(), all);
    ParameterValues some;
    some[static_cast<std::size_t>(ParameterField::DribblerDuty)] = 7;
    EXPECT_EQ(readParameterFile(writeParameterFile(some)).value(), some);
    EXPECT_EQ(readParameterFile(writeParameterFile({})).value(), ParameterValues{});
}

TEST(ParameterFile, FlashContentsThatMeanNothingAreWrittenAsNoData) {
    ParameterValues values;
    values[0] = 77;
    EXPECT_EQ(readParameterFile(writeParameterFile(values)).value()[0], 0xFF);
}

TEST(ParameterFile, ValuesMayBeWrittenAsAPersonDoes) {
    const auto read = readParameterFile(withFields(
        R"({"flash_contents": "fpga", "channel0": "0x0E", "channel1": "none", "dribbler_duty": "50%"})"));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(*read, (ParameterValues{std::uint8_t{0}, std::uint8_t{14}, std::uint8_t{0}, std::nullopt,
                                      std::uint8_t{128}}));
}

TEST(ParameterFile, WhatIsNoSuchFileIsRefused) {
    for (const char* file :
         {"", "[]", "{", "{}", "null", R"({"kickstand": "sweep", "version": 1, "parameters": {}})",
          R"({"kickstand": "parameters", "version": 2, "parameters": {}})",
          R"({"kickstand": "parameters", "version": 1})",
          R"({"kickstand": "parameters", "version": 1, "parameters": [1]})"})
        EXPECT_EQ(codeOf(file), Errc::Malformed) << file;
    EXPECT_EQ(codeOf(QByteArray(kLongestParameterFile + 1, ' ')), Errc::Malformed);
}

TEST(ParameterFile, FieldsAreChecked) {
    EXPECT_EQ(codeOf(withFields(R"({"channel0": 10})")), Errc::OutOfRange);
    EXPECT_EQ(codeOf(withFields(R"({"robot_number": 16})")), Errc::OutOfRange);
    EXPECT_EQ(codeOf(withFields(R"({"dribbler_duty": -1})")), Errc::OutOfRange);
    EXPECT_EQ(codeOf(withFields(R"({"dribbler_duty": 1.5})")), Errc::Malformed);
    EXPECT_EQ(codeOf(withFields(R"({"dribbler_duty": 1e300})")), Errc::Malformed);
    EXPECT_EQ(codeOf(withFields(R"({"dribbler_duty": [3]})")), Errc::Malformed);
    EXPECT_EQ(codeOf(withFields(R"({"flash_contents": "both"})")), Errc::Malformed);
    EXPECT_EQ(codeOf(withFields(R"({"dribler_duty": 3})")), Errc::UnknownName);
}

}  // namespace
}  // namespace kickstand
