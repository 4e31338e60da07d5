#include "core/thunderbots/image/intel_hex.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/unit/image/image_files.h"

namespace kickstand::thunderbots::image {
namespace {

using namespace testing;

ImageResult<ImageData> read(const std::string& text) {
    return readIntelHex(bytesOf(text));
}

std::string withEnd(const std::string& records) {
    return records + hexRecord(1, 0, {}) + "\n";
}

ImageError errorOf(const std::string& text) {
    const auto data = read(text);
    EXPECT_FALSE(data.has_value());
    return data ? ImageError{} : data.error();
}

TEST(IntelHex, WhatIsWrittenReadsAsTheSame) {
    std::mt19937 engine(5);
    const auto random = [&engine] { return static_cast<std::uint32_t>(engine()); };
    for (int round = 0; round < 50; ++round) {
        FlashImage image;
        std::uint32_t at = random() % 0x18000;
        for (int piece = 0; piece < 12; ++piece) {
            const std::uint32_t end = at + 1 + random() % 3000;
            image.data.push_back({at, end, 0});
            image.bytes.resize(end, kErased);
            for (std::uint32_t byte = at; byte < end; ++byte)
                image.bytes[byte] = static_cast<std::uint8_t>(random());
            at = end + 1 + random() % 100000;
        }
        const auto data = read(hexOf(image, 1 + random() % 255));
        ASSERT_TRUE(data.has_value()) << name(data.error().fault) << ' ' << data.error().line;
        EXPECT_EQ(data->bytes, image.bytes);
        ASSERT_EQ(data->ranges.size(), image.data.size());
        for (std::size_t i = 0; i < image.data.size(); ++i) {
            EXPECT_EQ(data->ranges[i].begin, image.data[i].begin);
            EXPECT_EQ(data->ranges[i].end, image.data[i].end);
        }
    }
}

TEST(IntelHex, TheLinesOfAFileMayComeInAnyOrder) {
    const auto data = read(
        withEnd(hexRecord(0, 8, {3}) + "\n" + hexRecord(0, 0, {1}) + "\n" + hexRecord(0, 1, {2}) + "\n"));
    ASSERT_TRUE(data.has_value());
    EXPECT_EQ(data->bytes, (Bytes{1, 2, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 3}));
    EXPECT_EQ(data->ranges, (std::vector<DataRange>{{0, 2, 2}, {8, 9, 1}}));
}

TEST(IntelHex, APieceThatClosesAGapJoinsItsNeighbours) {
    const auto data = read(
        withEnd(hexRecord(0, 0, {1}) + "\n" + hexRecord(0, 2, {3}) + "\n" + hexRecord(0, 1, {2}) + "\n"));
    ASSERT_TRUE(data.has_value());
    EXPECT_EQ(data->ranges, (std::vector<DataRange>{{0, 3, 1}}));
}

TEST(IntelHex, LinesEndWithLfOrCrOrBothAndMayBeEmpty) {
    const std::string record = hexRecord(0, 0, {7});
    for (const std::string end : {"\n", "\r", "\r\n", " \t\r\n\r\n", "\n\n\n"}) {
        const auto data = read("\n" + record + end + hexRecord(1, 0, {}) + end);
        ASSERT_TRUE(data.has_value()) << name(data.error().fault);
        EXPECT_EQ(data->bytes, Bytes{7});
    }
}

TEST(IntelHex, LinearAddressesGoOnWhereSegmentsBeginAnew) {
    const auto linear = read(withEnd(hexRecord(4, 0, {0, 1}) + "\n" + hexRecord(0, 0xFFFF, {1, 2}) + "\n"));
    ASSERT_TRUE(linear.has_value());
    EXPECT_EQ(linear->ranges, (std::vector<DataRange>{{0x1FFFF, 0x20001, 2}}));
    const auto segment =
        read(withEnd(hexRecord(2, 0, {0x10, 0}) + "\n" + hexRecord(0, 0xFFFF, {1, 2}) + "\n"));
    ASSERT_TRUE(segment.has_value());
    EXPECT_EQ(segment->ranges, (std::vector<DataRange>{{0x10000, 0x10001, 2}, {0x1FFFF, 0x20000, 2}}));
}

TEST(IntelHex, TheHighestAddressOfTheFormatIsRefusedLikeAnyOther) {
    const ImageError error =
        errorOf(withEnd(hexRecord(4, 0, {0xFF, 0xFF}) + "\n" + hexRecord(0, 0xFFFF, {1, 2}) + "\n"));
    EXPECT_EQ(error.fault, ImageFault::PastEnd);
    EXPECT_EQ(error.address, 0xFFFFFFFFU);
    EXPECT_EQ(error.line, 2U);
}

TEST(IntelHex, EveryChangedDigitOfARecordIsNoticed) {
    const std::string record = hexRecord(0, 0x1234, {0xDE, 0xAD, 0xBE, 0xEF});
    const std::string end = "\n" + hexRecord(1, 0, {}) + "\n";
    for (std::size_t at = 1; at < record.size(); ++at) {
        for (const char digit : {'0', '5', 'A', 'g', ':'}) {
            std::string changed = record;
            if (changed[at] == digit) continue;
            changed[at] = digit;
            EXPECT_FALSE(read(changed + end).has_value()) << changed;
        }
    }
}

TEST(IntelHex, AFileCutOffAnywhereIsRefused) {
    const std::string whole = withEnd(hexRecord(0, 0, {1, 2, 3}) + "\n");
    for (std::size_t length = 0; length + 1 < whole.size(); ++length)
        EXPECT_FALSE(read(whole.substr(0, length)).has_value()) << length;
}

}  // namespace
}  // namespace kickstand::thunderbots::image
