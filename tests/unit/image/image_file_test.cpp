#include "core/thunderbots/image/image_file.h"

#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "tests/unit/image/image_files.h"

namespace kickstand::thunderbots::image {
namespace {

using namespace testing;

struct Expected {
    ImageFault fault;
    std::uint32_t line = 0;
    std::uint32_t address = 0;
};

const std::map<std::string, Expected> kMalformed{
    {"junk.hex", {ImageFault::Junk, 2}},
    {"junk-in-record.hex", {ImageFault::Junk, 2}},
    {"no-colon.hex", {ImageFault::Junk, 2}},
    {"bad-checksum.hex", {ImageFault::BadChecksum, 2}},
    {"record-too-short.hex", {ImageFault::BadLength, 2}},
    {"record-too-long.hex", {ImageFault::BadLength, 2}},
    {"odd-digits.hex", {ImageFault::BadLength, 2}},
    {"unknown-type.hex", {ImageFault::UnknownType, 2}},
    {"base-of-one-byte.hex", {ImageFault::BadLength, 2}},
    {"end-with-data.hex", {ImageFault::BadLength, 2}},
    {"overlap.hex", {ImageFault::Overlap, 3, 3}},
    {"overlap-across.hex", {ImageFault::Overlap, 2, 8}},
    {"missing-end.hex", {ImageFault::MissingEnd, 1}},
    {"after-end.hex", {ImageFault::AfterEnd, 3}},
    {"past-flash.hex", {ImageFault::PastEnd, 3, kFlashBytes}},
    {"across-flash-end.hex", {ImageFault::PastEnd, 3, kFlashBytes}},
    {"no-data.hex", {ImageFault::Empty}},
    {"empty.bin", {ImageFault::Empty}},
    {"cut-off.bit", {ImageFault::BadLength}},
    {"too-much.bit", {ImageFault::BadLength}},
    {"cut-in-header.bit", {ImageFault::BadHeader}},
    {"no-preamble.bit", {ImageFault::BadHeader}},
    {"control-character.bit", {ImageFault::BadHeader}},
    {"no-bitstream.bit", {ImageFault::Empty}},
    {"length-of-4-gigabytes.bit", {ImageFault::BadLength}},
};

TEST(ImageFiles, EachMalformedOneIsRefusedForItsReason) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(KICKSTAND_IMAGE_DATA "/malformed")) {
        const std::string file = entry.path().filename().string();
        SCOPED_TRACE(file);
        const auto expected = kMalformed.find(file);
        ASSERT_NE(expected, kMalformed.end());
        const auto image = imageOf("malformed/" + file);
        ASSERT_FALSE(image.has_value());
        EXPECT_STREQ(name(image.error().fault), name(expected->second.fault));
        EXPECT_EQ(image.error().line, expected->second.line);
        EXPECT_EQ(image.error().address, expected->second.address);
        ++files;
    }
    EXPECT_EQ(files, kMalformed.size());
}

TEST(ImageFiles, TheSameFirmwareReadsTheSameFromEachFile) {
    const Bytes firmware = readData("good/firmware.bin");
    ASSERT_EQ(firmware.size(), 64U);
    for (const char* file : {"firmware.hex", "lower-case-crlf.hex", "no-last-line-end.hex", "firmware.bin"}) {
        const auto image = imageOf(std::string("good/") + file);
        ASSERT_TRUE(image.has_value()) << file;
        EXPECT_EQ(image->bytes, firmware) << file;
        EXPECT_EQ(image->dataBytes(), 64U) << file;
        EXPECT_EQ(image->guess, (TargetGuess{FlashTarget::Microcontroller, GuessReason::ResetVector}))
            << file;
    }
}

TEST(ImageFiles, GapsAreErasedAndNotData) {
    const auto image = imageOf("good/gaps.hex");
    ASSERT_TRUE(image.has_value());
    EXPECT_EQ(image->data, (std::vector<DataRange>{{0, 8, 1}, {0x30, 0x31, 3}, {0x40, 0x42, 2}}));
    ASSERT_EQ(image->bytes.size(), 0x42U);
    EXPECT_EQ(image->bytes[0x2F], kErased);
    EXPECT_EQ(image->bytes[0x30], 0x30);
    EXPECT_EQ(image->bytes[0x31], kErased);
    EXPECT_EQ(image->dataBytes(), 11U);
}

TEST(ImageFiles, EveryRecordTypeIsKnown) {
    const auto image = imageOf("good/all-record-types.hex");
    ASSERT_TRUE(image.has_value());
    EXPECT_EQ(image->data, (std::vector<DataRange>{{0, 4, 2}, {0x1010, 0x1012, 4}, {0x10010, 0x10012, 6}}));
    EXPECT_EQ(image->bytes[0x1010], 0x11);
    EXPECT_EQ(image->bytes[0x10011], 0x22);
}

TEST(ImageFiles, ABitFileGivesItsBitstreamAndSaysWhatItIsFor) {
    const auto image = imageOf("good/bitstream.bit");
    ASSERT_TRUE(image.has_value());
    EXPECT_EQ(image->bytes, readData("good/bitstream.bin"));
    EXPECT_EQ(image->header,
              (BitHeader{"robot.ncd;UserID=0xFFFFFFFF", "3s50avq100", "2011/06/24", "12:04:03"}));
    EXPECT_EQ(image->guess, (TargetGuess{FlashTarget::Fpga, GuessReason::BitHeader}));
    EXPECT_EQ(imageOf("good/bitstream.bin")->guess, (TargetGuess{FlashTarget::Fpga, GuessReason::SyncWord}));
}

TEST(ImageFiles, ABitFileCutOffAnywhereIsRefused) {
    const Bytes whole = readData("good/bitstream.bit");
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_FALSE(readImage("cut.bit", ByteView(whole).first(length)).has_value()) << length;
    }
}

TEST(ImageFiles, TheFormatComesFromTheNameElseFromTheContents) {
    const Bytes hex = readData("good/firmware.hex");
    const Bytes bit = readData("good/bitstream.bit");
    const Bytes plain = readData("good/firmware.bin");
    EXPECT_EQ(formatOf("new", hex), ImageFormat::IntelHex);
    EXPECT_EQ(formatOf("new", bit), ImageFormat::XilinxBit);
    EXPECT_EQ(formatOf("new", plain), ImageFormat::Binary);
    EXPECT_EQ(formatOf("", {}), ImageFormat::Binary);
    EXPECT_EQ(formatOf("a.HEX", plain), ImageFormat::IntelHex);
    EXPECT_EQ(formatOf("a.mcs", plain), ImageFormat::IntelHex);
    EXPECT_EQ(formatOf("a.Bit", plain), ImageFormat::XilinxBit);
    EXPECT_EQ(formatOf("a.bin", hex), ImageFormat::Binary);
}

TEST(ImageFiles, AFileThatIsTooLargeIsNotRead) {
    const Bytes large(kLargestFile + 1, 0);
    const auto image = readImage("a.bin", large);
    ASSERT_FALSE(image.has_value());
    EXPECT_EQ(image.error().fault, ImageFault::TooLarge);
    EXPECT_EQ(image.error().got, kLargestFile + 1);
}

TEST(ImageFiles, ABinaryFileOfAWholeFlashIsReadAndNotAByteMore) {
    EXPECT_EQ(readImage("a.bin", Bytes(kFlashBytes, 1))->data.front().end, kFlashBytes);
    const auto longer = readImage("a.bin", Bytes(kFlashBytes + 1, 1));
    ASSERT_FALSE(longer.has_value());
    EXPECT_EQ(longer.error().fault, ImageFault::PastEnd);
    EXPECT_EQ(longer.error().address, kFlashBytes);
}

}  // namespace
}  // namespace kickstand::thunderbots::image
