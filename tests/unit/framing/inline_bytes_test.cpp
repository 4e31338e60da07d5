#include "core/framing/inline_bytes.h"

#include <array>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using Four = InlineBytes<4>;

TEST(InlineBytes, AppendsAllOrNothing) {
    Four bytes;
    EXPECT_TRUE(bytes.append(std::array<std::uint8_t, 3>{1, 2, 3}));
    EXPECT_FALSE(bytes.append(std::array<std::uint8_t, 2>{4, 5}));
    EXPECT_EQ(bytes.size(), 3U);
    EXPECT_TRUE(bytes.append(std::uint8_t{4}));
    EXPECT_FALSE(bytes.append(std::uint8_t{5}));
    EXPECT_EQ(bytes[3], 4);
}

TEST(InlineBytes, GrowsWithZerosAndNeverPastItsCapacity) {
    Four bytes;
    bytes.append(std::array<std::uint8_t, 4>{9, 9, 9, 9});
    bytes.clear();
    EXPECT_TRUE(bytes.empty());
    EXPECT_TRUE(bytes.resize(2));
    EXPECT_EQ(bytes[0], 0);
    EXPECT_EQ(bytes[1], 0);
    EXPECT_FALSE(bytes.resize(5));
    EXPECT_EQ(bytes.size(), 2U);
}

TEST(InlineBytes, ComparesWhatItHoldsAndNotWhatItHeld) {
    Four a;
    Four b;
    a.append(std::array<std::uint8_t, 2>{1, 2});
    b.append(std::array<std::uint8_t, 3>{1, 2, 3});
    EXPECT_NE(a, b);
    b.resize(2);
    EXPECT_EQ(a, b);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), a.view().begin(), a.view().end()));
}

TEST(InlineBytes, WhatIsWrittenIntoItsRoomIsCountedIn) {
    Four bytes;
    bytes.append(std::uint8_t{1});
    ASSERT_EQ(bytes.room().size(), 3U);
    bytes.room()[0] = 2;
    bytes.take(1);
    EXPECT_EQ(bytes.size(), 2U);
    EXPECT_EQ(bytes[1], 2);
    const Four copy = bytes;
    EXPECT_EQ(copy, bytes);
    bytes = copy;
    EXPECT_EQ(bytes.size(), 2U);
}

}  // namespace
}  // namespace kickstand
