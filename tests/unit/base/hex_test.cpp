#include "core/base/hex.h"

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Hex, IsWrittenInLowerCaseWithSpaces) {
    EXPECT_EQ(toHex({}), "");
    EXPECT_EQ(toHex(Bytes{0x00}), "00");
    EXPECT_EQ(toHex(Bytes{0x80, 0x7F, 0xE0}), "80 7f e0");
}

TEST(Hex, IsReadInEveryUsualForm) {
    const Bytes bytes{0x80, 0x7F, 0xE0};
    for (const char* text :
         {"80 7f e0", "807FE0", "80:7f:e0", "0x80 0x7F 0xE0", "  80\t7f\ne0\r\n", "0X807fe0"}) {
        const auto read = parseHex(text);
        ASSERT_TRUE(read) << text;
        EXPECT_EQ(*read, bytes) << text;
    }
    EXPECT_EQ(*parseHex(""), Bytes{});
    EXPECT_EQ(*parseHex(" \t"), Bytes{});
}

TEST(Hex, RoundTrips) {
    Bytes bytes(256);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(i);
    EXPECT_EQ(*parseHex(toHex(bytes)), bytes);
}

struct BadHex {
    const char* text;
    int at;
    const char* piece;
};

class HexErrors : public ::testing::TestWithParam<BadHex> {};

TEST_P(HexErrors, NameThePlace) {
    const auto read = parseHex(GetParam().text);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::Malformed);
    EXPECT_EQ(read.error().got, GetParam().at);
    EXPECT_EQ(read.error().detail, GetParam().piece);
}

INSTANTIATE_TEST_SUITE_P(Hex, HexErrors,
                         ::testing::Values(BadHex{"8", 0, "8"}, BadHex{"80 7", 3, "7"},
                                           BadHex{"80 xy", 3, "xy"}, BadHex{"8 0", 0, "8 "},
                                           BadHex{"0x", 2, ""}, BadHex{"80,7f", 2, ",7"}));

}  // namespace
}  // namespace kickstand
