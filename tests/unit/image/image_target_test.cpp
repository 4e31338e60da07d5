#include <set>

#include <gtest/gtest.h>

#include "core/framing/crc16.h"
#include "tests/unit/image/image_files.h"

namespace kickstand::thunderbots::image {
namespace {

using namespace testing;

FlashImage plain(Bytes bytes) {
    return *readImage("a.bin", bytes);
}

TEST(ImageTarget, WhatThePlaceForConfigurationHoldsIsLeftOutAndListed) {
    const auto whole = imageOf("good/configuration.hex");
    ASSERT_TRUE(whole.has_value());
    const auto image = forTarget(*whole, FlashTarget::Microcontroller);
    ASSERT_TRUE(image.has_value());
    EXPECT_EQ(image->data, (std::vector<DataRange>{{0, 64, 1}, {0x1EFFF, 0x1F000, 6}}));
    EXPECT_EQ(image->skipped, (std::vector<DataRange>{{0x1F000, 0x1F001, 0}, {0x1FFF8, 0x20000, 7}}));
    EXPECT_EQ(image->bytes.size(), kMicrocontrollerCopiedBytes);
    EXPECT_EQ(image->bytes.back(), 0x5A);
}

TEST(ImageTarget, DataPastTheMicrocontrollerIsRefusedWithItsAddress) {
    Bytes bytes(kMicrocontrollerBytes + 1, 0x11);
    const auto image = forTarget(plain(bytes), FlashTarget::Microcontroller);
    ASSERT_FALSE(image.has_value());
    EXPECT_EQ(image.error().fault, ImageFault::PastEnd);
    EXPECT_EQ(image.error().address, kMicrocontrollerBytes);
    EXPECT_EQ(image.error().most, kMicrocontrollerBytes - 1);
    EXPECT_EQ(image.error().line, 0U);
    bytes.pop_back();
    EXPECT_TRUE(forTarget(plain(bytes), FlashTarget::Microcontroller).has_value());
}

TEST(ImageTarget, DataPastTheMicrocontrollerIsRefusedWithItsLine) {
    const std::string text = hexRecord(0, 0, {1}) + "\n" + hexRecord(4, 0, {0, 0x10}) + "\n" +
                             hexRecord(0, 5, {2}) + "\n" + hexRecord(1, 0, {}) + "\n";
    const auto image = forTarget(*readImage("a.hex", bytesOf(text)), FlashTarget::Microcontroller);
    ASSERT_FALSE(image.has_value());
    EXPECT_EQ(image.error().line, 3U);
    EXPECT_EQ(image.error().address, 0x100005U);
}

TEST(ImageTarget, AnImageOfTheOtherTargetIsRefused) {
    const auto firmware = forTarget(*imageOf("good/firmware.bin"), FlashTarget::Fpga);
    ASSERT_FALSE(firmware.has_value());
    EXPECT_EQ(firmware.error().fault, ImageFault::LooksLikeOther);
    EXPECT_EQ(firmware.error().reason, GuessReason::ResetVector);
    const auto bitstream = forTarget(*imageOf("good/bitstream.bit"), FlashTarget::Microcontroller);
    ASSERT_FALSE(bitstream.has_value());
    EXPECT_EQ(bitstream.error().fault, ImageFault::LooksLikeOther);
    EXPECT_EQ(bitstream.error().reason, GuessReason::BitHeader);
}

TEST(ImageTarget, ABitstreamWithItsBitsTurnedRoundIsOneToo) {
    EXPECT_EQ(plain({0xFF, 0xFF, 0x55, 0x99, 0xAA, 0x66, 0}).guess.target, FlashTarget::Fpga);
}

TEST(ImageTarget, WithoutAnySignTheChoiceIsAPersons) {
    const FlashImage image = plain(Bytes(100, 0x42));
    EXPECT_FALSE(image.guess.certain());
    for (const FlashTarget target : {FlashTarget::Microcontroller, FlashTarget::Fpga}) {
        const auto settled = forTarget(image, target);
        ASSERT_TRUE(settled.has_value());
        EXPECT_EQ(settled->target, target);
        EXPECT_EQ(settled->bytes, image.bytes);
    }
}

TEST(ImageTarget, MoreThanTheMicrocontrollerHoldsIsForTheFpga) {
    EXPECT_EQ(plain(Bytes(kMicrocontrollerBytes + 1, 0)).guess,
              (TargetGuess{FlashTarget::Fpga, GuessReason::Size}));
}

TEST(ImageTarget, FirmwareOfConfigurationAloneIsRefused) {
    const std::string text =
        hexRecord(4, 0, {0, 1}) + "\n" + hexRecord(0, 0xFFF8, {1, 2}) + "\n" + hexRecord(1, 0, {}) + "\n";
    const auto image = forTarget(*readImage("a.hex", bytesOf(text)), FlashTarget::Microcontroller);
    ASSERT_FALSE(image.has_value());
    EXPECT_EQ(image.error().fault, ImageFault::Empty);
}

TEST(ImageTarget, SignaturesAreThoseOfThePaddedImage) {
    const auto image = forTarget(*imageOf("good/configuration.hex"), FlashTarget::Microcontroller);
    ASSERT_TRUE(image.has_value());
    Bytes padded = image->bytes;
    padded.resize(kMicrocontrollerCopiedBytes, kErased);
    EXPECT_EQ(signaturesOf(*image).microcontroller, crc16(padded));
    padded.resize(kFlashBytes, kErased);
    EXPECT_EQ(signaturesOf(*image).flash, crc16(padded));
}

TEST(ImageTarget, WhatLiesAboveTheFirmwareDoesNotChangeItsSignature) {
    FlashImage image = *imageOf("good/configuration.hex");
    const std::uint16_t before = signaturesOf(image).microcontroller;
    image.bytes[0x1FFFF] ^= 0xFF;
    EXPECT_EQ(signaturesOf(image).microcontroller, before);
    image.bytes[0x1EFFF] ^= 0xFF;
    EXPECT_NE(signaturesOf(image).microcontroller, before);
}

TEST(ImageTarget, NamesAreStableAndApart) {
    std::set<std::string> faults;
    for (int fault = 0; fault <= static_cast<int>(ImageFault::LooksLikeOther); ++fault)
        faults.insert(name(static_cast<ImageFault>(fault)));
    EXPECT_EQ(faults.size(), 12U);
    EXPECT_EQ(faults.count("unknown"), 0U);
    EXPECT_STREQ(name(FlashTarget::Fpga), "fpga");
    EXPECT_STREQ(name(ImageFormat::XilinxBit), "xilinx-bit");
    const Error error = toError({ImageFault::PastEnd, 7, 0x20000, 0, 0, {}, {}}, "robot.hex");
    EXPECT_EQ(error.subject, "robot.hex");
    EXPECT_EQ(error.detail, "past-end, line 7, address 131072");
}

}  // namespace
}  // namespace kickstand::thunderbots::image
