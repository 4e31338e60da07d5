#include "core/framing/crc16.h"

#include <cstddef>
#include <numeric>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytesOf(std::string_view text) {
    return {text.begin(), text.end()};
}

/// The definition, bit by bit: what the table must agree with.
std::uint16_t bitwise(const Bytes& bytes) {
    std::uint16_t crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc = static_cast<std::uint16_t>(crc ^ byte);
        for (int i = 0; i < 8; ++i) {
            crc = static_cast<std::uint16_t>((crc & 1) != 0 ? (crc >> 1) ^ 0x8408 : crc >> 1);
        }
    }
    return crc;
}

TEST(Crc16, GivesTheCheckValueOfMcrf4xx) {
    EXPECT_EQ(crc16(bytesOf("123456789")), 0x6F91);
}

TEST(Crc16, OfNothingIsTheInitialValue) {
    EXPECT_EQ(crc16({}), kCrc16Initial);
}

TEST(Crc16, AgreesWithTheBitwiseDefinitionOnEveryByteValue) {
    Bytes bytes(256);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    EXPECT_EQ(crc16(bytes), bitwise(bytes));
    for (int value = 0; value < 256; ++value) {
        const Bytes one{static_cast<std::uint8_t>(value)};
        ASSERT_EQ(crc16(one), bitwise(one)) << value;
    }
}

TEST(Crc16, MayBeComputedInPiecesCutAnywhere) {
    const Bytes whole = bytesOf("123456789");
    const ByteView view = whole;
    for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
        EXPECT_EQ(crc16(view.subspan(cut), crc16(view.first(cut))), 0x6F91) << cut;
    }
}

TEST(Crc16, FillIsTheCrcOfThatManyEqualBytes) {
    EXPECT_EQ(crc16Fill(0xFF, 0), kCrc16Initial);
    EXPECT_EQ(crc16Fill(0xFF, 300), crc16(Bytes(300, 0xFF)));
    Bytes image = bytesOf("firmware");
    const std::uint16_t start = crc16(image);
    image.resize(4096, 0xFF);
    EXPECT_EQ(crc16Fill(0xFF, 4096 - 8, start), crc16(image));
}

}  // namespace
}  // namespace kickstand
