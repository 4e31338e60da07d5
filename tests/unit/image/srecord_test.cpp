// Files and CRCs made by srec_cat, of the srecord package, agree with ours. Left out where it is not
// installed.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "tests/unit/image/image_files.h"

namespace kickstand::thunderbots::image {
namespace {

using namespace testing;
namespace fs = std::filesystem;

class SrecordTest : public ::testing::Test {
  protected:
    void SetUp() override {
        if (std::string(KICKSTAND_SREC_CAT).empty()) GTEST_SKIP() << "srecord is not installed";
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(::testing::TempDir()) / (std::string("kickstand-image-") + test->name());
        fs::create_directories(folder_);
    }
    void TearDown() override {
        std::error_code error;
        if (!folder_.empty()) fs::remove_all(folder_, error);
    }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    void run(const std::string& arguments) const {
        EXPECT_EQ(std::system((std::string(KICKSTAND_SREC_CAT) + " " + arguments).c_str()), 0) << arguments;
    }
    Bytes read(const std::string& name) const {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// Its CRC of `length` bytes of flash that holds this file. Its CRCs begin with zero: turning the first
    /// two bytes over makes that begin with 0xFFFF.
    std::uint16_t crc(const std::string& name, std::uint32_t length) const {
        const std::string padded = file(name) + " -binary -fill 0xff 0 " + std::to_string(length);
        const std::string end = std::to_string(length);
        run("'(' '(' " + padded + " -crop 0 2 -xor 0xff ')' '(' " + padded + " -crop 2 " + end +
            " ')' ')' -crc16-l-e " + end + " -xmodem -least-to-most -crop " + end + " " +
            std::to_string(length + 2) + " -offset -" + end + " -o " + file("crc") + " -binary");
        const Bytes bytes = read("crc");
        EXPECT_EQ(bytes.size(), 2U);
        return bytes.size() == 2 ? loadLe16(bytes, 0) : 0;
    }

    fs::path folder_;
};

TEST_F(SrecordTest, ItsIntelHexInEveryAddressingIsReadAsItsBinary) {
    run("-generate 0 1000 -repeat-data 0x10 0xEF 0x00 0xF0 0x55 0xAA 7 -generate 0x12345 0x19999 "
        "-repeat-string kickstand -o " +
        file("sparse.hex") + " -intel");
    run(file("sparse.hex") + " -intel -fill 0xff 0 0x19999 -o " + file("plain.bin") + " -binary");
    const auto image = readImage("sparse.hex", read("sparse.hex"));
    ASSERT_TRUE(image.has_value()) << name(image.error().fault) << ' ' << image.error().line;
    EXPECT_EQ(image->bytes, read("plain.bin"));
    ASSERT_EQ(image->data.size(), 2U);
    EXPECT_EQ(image->data[1].begin, 0x12345U);
    EXPECT_EQ(image->data[1].end, 0x19999U);
    for (const char* addresses : {"-address-length=3", "-address-length=4"}) {
        run(file("sparse.hex") + " -intel -o " + file("again.hex") + " -intel " + addresses);
        const auto again = readImage("again.hex", read("again.hex"));
        ASSERT_TRUE(again.has_value()) << addresses << ' ' << name(again.error().fault);
        EXPECT_EQ(again->bytes, image->bytes) << addresses;
    }
}

TEST_F(SrecordTest, ItReadsTheFilesOfThisProjectAsWeDo) {
    for (const char* good :
         {"all-record-types.hex", "gaps.hex", "configuration.hex", "lower-case-crlf.hex"}) {
        const auto image = imageOf(std::string("good/") + good);
        ASSERT_TRUE(image.has_value()) << good;
        run(std::string(KICKSTAND_IMAGE_DATA "/good/") + good + " -intel -fill 0xff 0 " +
            std::to_string(image->bytes.size()) + " -o " + file("theirs.bin") + " -binary");
        EXPECT_EQ(image->bytes, read("theirs.bin")) << good;
    }
}

TEST_F(SrecordTest, ItsCrcsAreTheSignatures) {
    run("-generate 0 0x1E123 -repeat-string 'the quick brown fox' -o " + file("image.bin") + " -binary");
    const auto image = readImage("image.bin", read("image.bin"));
    ASSERT_TRUE(image.has_value());
    const ImageSignatures ours = signaturesOf(*image);
    EXPECT_EQ(crc("image.bin", kMicrocontrollerCopiedBytes), ours.microcontroller);
    EXPECT_EQ(crc("image.bin", kFlashBytes), ours.flash);
}

}  // namespace
}  // namespace kickstand::thunderbots::image
