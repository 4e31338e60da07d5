#include "core/framing/bit_field.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using Block = std::array<std::uint8_t, 12>;

bool bitAt(const Block& block, BitOrder order, std::size_t bit) {
    const std::size_t inByte = order == BitOrder::MsbFirst ? 7 - bit % 8 : bit % 8;
    return (block[bit / 8] >> inByte & 1) != 0;
}

/// The definition of both orders, bit by bit.
std::uint32_t readBitwise(const Block& block, BitOrder order, std::size_t first, unsigned width) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < width; ++i) {
        const std::uint64_t bit = bitAt(block, order, first + i) ? 1 : 0;
        value = order == BitOrder::MsbFirst ? value << 1 | bit : value | bit << i;
    }
    return static_cast<std::uint32_t>(value);
}

Block randomBlock(std::mt19937& random) {
    Block block{};
    for (auto& byte : block)
        byte = static_cast<std::uint8_t>(random());
    return block;
}

template <BitOrder order>
void checkEveryPlace() {
    std::mt19937 random(1);
    for (unsigned width = 1; width <= kMaxFieldBits; ++width) {
        for (std::size_t first = 0; first + width <= sizeof(Block) * 8; ++first) {
            const Block before = randomBlock(random);
            ASSERT_EQ(readBits<order>(before, first, width), readBitwise(before, order, first, width))
                << first << '+' << width;

            const auto value = static_cast<std::uint32_t>(random());
            Block after = before;
            writeBits<order>(after, first, width, value);
            const auto mask = static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
            ASSERT_EQ(readBitwise(after, order, first, width), value & mask) << first << '+' << width;
            for (std::size_t bit = 0; bit < sizeof(Block) * 8; ++bit) {
                if (bit >= first && bit < first + width) continue;
                ASSERT_EQ(bitAt(after, order, bit), bitAt(before, order, bit)) << "bit " << bit << " changed";
            }
        }
    }
}

TEST(BitField, MsbFirstReadsAndWritesAnyWidthAtAnyPlace) {
    checkEveryPlace<BitOrder::MsbFirst>();
}

TEST(BitField, LsbFirstReadsAndWritesAnyWidthAtAnyPlace) {
    checkEveryPlace<BitOrder::LsbFirst>();
}

TEST(BitField, LsbFirstWholeBytesAreLittleEndian) {
    const std::array<std::uint8_t, 3> bytes{0x11, 0x34, 0x12};
    EXPECT_EQ(readBits<BitOrder::LsbFirst>(bytes, 8, 16), 0x1234U);
    EXPECT_EQ(readBits<BitOrder::LsbFirst>(bytes, 8, 16), loadLe16(bytes, 1));
}

TEST(BitField, SignExtendCoversTheWholeRangeOfAWidth) {
    EXPECT_EQ(signExtend(0x3FF, 11), 1023);
    EXPECT_EQ(signExtend(0x400, 11), -1024);
    EXPECT_EQ(signExtend(0x7FF, 11), -1);
    EXPECT_EQ(signExtend(1, 1), -1);
    EXPECT_EQ(signExtend(0x80000000U, 32), INT32_MIN);
    EXPECT_EQ(signExtend(0x7FFFFFFFU, 32), INT32_MAX);
}

}  // namespace
}  // namespace kickstand
