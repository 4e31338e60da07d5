#include <set>

#include <gtest/gtest.h>

#include "core/engine/describe_images.h"

namespace kickstand {
namespace {

using namespace thunderbots::image;

ImageError errorOf(ImageFault fault) {
    return {fault, 12, 0x1F000, 58, 59, FlashTarget::Microcontroller, GuessReason::SyncWord};
}

TEST(DescribeImages, EveryFaultHasASentenceOfItsOwnAndARemedy) {
    std::set<QString> seen;
    for (int fault = 0; fault <= static_cast<int>(ImageFault::LooksLikeOther); ++fault) {
        const Description words = describe(errorOf(static_cast<ImageFault>(fault)));
        EXPECT_TRUE(words.what.endsWith(u'.')) << words.what.toStdString();
        EXPECT_FALSE(words.what.contains(u'%')) << words.what.toStdString();
        EXPECT_FALSE(words.remedy.isEmpty()) << words.what.toStdString();
        EXPECT_TRUE(seen.insert(words.what).second) << words.what.toStdString();
    }
}

TEST(DescribeImages, NamesTheLineAndTheAddress) {
    EXPECT_EQ(describe(errorOf(ImageFault::BadChecksum)).what.toStdString(),
              "Line 12 is damaged: its checksum is 0x3a, and its bytes give 0x3b.");
    ImageError past = errorOf(ImageFault::PastEnd);
    past.address = kMicrocontrollerBytes;
    past.most = kMicrocontrollerBytes - 1;
    EXPECT_EQ(describe(past).what.toStdString(),
              "Line 12 has data for address 0x20000; the last address of the microcontroller is 0x1ffff.");
    past.line = 0;
    EXPECT_EQ(describe(past).what.toStdString(),
              "There is data at address 0x20000; the last address of the microcontroller is 0x1ffff.");
}

TEST(DescribeImages, ALengthIsInDigitsOfALineAndInBytesOfABitstream) {
    ImageError error = errorOf(ImageFault::BadLength);
    EXPECT_EQ(describe(error).what.toStdString(), "Line 12 has 58 hex digits where 59 belong.");
    error.line = 0;
    EXPECT_EQ(describe(error).what.toStdString(), "The bitstream has 58 bytes where its header promises 59.");
}

TEST(DescribeImages, SaysWhichTargetAFileIsForAndWhy) {
    EXPECT_EQ(
        describe(errorOf(ImageFault::LooksLikeOther)).line().toStdString(),
        "This is a bitstream for the FPGA, not firmware: it begins with the word by which an FPGA finds "
        "its bitstream. Choose the other target, or the right file.");
}

}  // namespace
}  // namespace kickstand
