#include "core/framing/cobs.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes encoded(const Bytes& bytes) {
    Bytes out(cobsMost(bytes.size()));
    out.resize(cobsEncode(bytes, out));
    return out;
}

Bytes decoded(const Bytes& encoding) {
    Bytes out(encoding.size());
    const auto size = cobsDecode(encoding, out);
    if (!size) return {0xDE, 0xAD};
    out.resize(*size);
    return out;
}

CobsFault faultOf(const Bytes& encoding) {
    Bytes out(encoding.size());
    const auto size = cobsDecode(encoding, out);
    EXPECT_FALSE(size);
    return size ? CobsFault{} : size.error();
}

/// `count` bytes 1, 2, … 255, 1, …: none is zero.
Bytes counting(std::size_t count) {
    Bytes bytes(count);
    for (std::size_t i = 0; i < count; ++i)
        bytes[i] = static_cast<std::uint8_t>(i % 255 + 1);
    return bytes;
}

Bytes operator+(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST(Cobs, KnownEncodings) {
    EXPECT_EQ(encoded({}), Bytes({1}));
    EXPECT_EQ(encoded({0}), Bytes({1, 1}));
    EXPECT_EQ(encoded({0, 0}), Bytes({1, 1, 1}));
    EXPECT_EQ(encoded({0x11, 0x22, 0, 0x33}), Bytes({3, 0x11, 0x22, 2, 0x33}));
    EXPECT_EQ(encoded({0x11, 0, 0, 0}), Bytes({2, 0x11, 1, 1, 1}));
    EXPECT_EQ(encoded({0x10, 0x00, 0x10}), Bytes({2, 0x10, 2, 0x10}));
}

TEST(Cobs, FullBlocks) {
    EXPECT_EQ(encoded(counting(253)), Bytes({254}) + counting(253));
    EXPECT_EQ(encoded(counting(254)), Bytes({255}) + counting(254));
    EXPECT_EQ(encoded(counting(255)), Bytes({255}) + counting(254) + Bytes({2, 255}));
    EXPECT_EQ(encoded(counting(254) + Bytes{0}), Bytes({255}) + counting(254) + Bytes({1, 1}));
    EXPECT_EQ(encoded(Bytes{0} + counting(254)), Bytes({1, 255}) + counting(254));
    EXPECT_EQ(encoded(Bytes{7, 0} + counting(254) + Bytes{9}),
              Bytes({2, 7, 255}) + counting(254) + Bytes({2, 9}));
}

TEST(Cobs, EverythingComesBackAndNothingIsZero) {
    std::mt19937 random(1);
    for (int round = 0; round < 20'000; ++round) {
        Bytes bytes(random() % 800);
        const auto zeros = random() % 100;
        for (std::uint8_t& byte : bytes)
            byte = random() % 100 < zeros ? 0 : static_cast<std::uint8_t>(random());
        const Bytes encoding = encoded(bytes);
        ASSERT_EQ(std::count(encoding.begin(), encoding.end(), 0), 0);
        ASSERT_EQ(decoded(encoding), bytes);
    }
}

TEST(Cobs, WhatNobodyEncodesIsRefused) {
    EXPECT_EQ(faultOf({}), CobsFault::Empty);
    EXPECT_EQ(faultOf({0}), CobsFault::Zero);
    EXPECT_EQ(faultOf({2}), CobsFault::Truncated);
    EXPECT_EQ(faultOf({3, 1}), CobsFault::Truncated);
    EXPECT_EQ(faultOf({2, 1, 5, 1}), CobsFault::Truncated);
    EXPECT_EQ(faultOf({3, 1, 0}), CobsFault::Zero);
    EXPECT_EQ(faultOf({255, 1, 2}), CobsFault::Truncated);
    EXPECT_EQ(faultOf(Bytes{1, 255} + counting(253)), CobsFault::Truncated);
    EXPECT_EQ(faultOf(Bytes{255} + counting(254) + Bytes{2}), CobsFault::Truncated);
}

TEST(Cobs, AnyBytesAreDecodedWithinTheirRoomOrRefused) {
    std::mt19937 random(2);
    for (int round = 0; round < 20'000; ++round) {
        Bytes bytes(1 + random() % 600);
        for (std::uint8_t& byte : bytes)
            byte = random() % 8 == 0 ? 255 : static_cast<std::uint8_t>(1 + random() % 40);
        Bytes out(bytes.size() + 1, 0xA5);
        const auto size = cobsDecode(bytes, ByteSpan(out).first(bytes.size()));
        ASSERT_EQ(out.back(), 0xA5) << "it wrote past its room";
        if (!size) continue;
        // A full block at the very end may be followed by an empty one or by nothing: both are read.
        out.resize(*size);
        ASSERT_EQ(decoded(encoded(out)), out);
    }
}

}  // namespace
}  // namespace kickstand
