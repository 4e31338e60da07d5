#include "core/thunderbots/wire/drive.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

struct Vector {
    DriveBlock block;
    const char* bytes;
};

DriveBlock running() {
    DriveBlock block;
    block.run = true;
    return block;
}

std::vector<Vector> specificationVectors() {
    std::vector<Vector> vectors;
    DriveBlock block = running();
    vectors.push_back({block, "80 00 00 00 00 00 00 00 00 00"});
    block.wheels[0] = 1023;
    vectors.push_back({block, "80 7f e0 00 00 00 00 00 00 00"});
    block.wheels[0] = -1023;
    vectors.push_back({block, "80 80 20 00 00 00 00 00 00 00"});
    block = running();
    block.wheels[3] = -1;
    vectors.push_back({block, "80 00 00 00 00 7f f0 00 00 00"});
    block = running();
    block.testClass = 5;
    block.testTarget = 4;
    vectors.push_back({block, "80 00 00 00 00 00 0b 00 00 00"});
    block = running();
    block.charge = true;
    block.autokickArmed = true;
    block.autokick = {true, false, 100, 47, 9};
    vectors.push_back({block, "d4 00 00 00 00 00 00 32 2f 12"});
    return vectors;
}

TEST(Drive, SpecificationVectorsBothWays) {
    for (const auto& [block, text] : specificationVectors()) {
        const auto encoded = encodeDrive(block);
        ASSERT_TRUE(encoded.has_value()) << text;
        EXPECT_EQ(bytesOf(*encoded), hex(text));
        const auto decoded = decodeDrive(hex(text));
        ASSERT_TRUE(decoded.has_value()) << text;
        EXPECT_EQ(*decoded, block) << text;
    }
}

TEST(Drive, BrakedBlockIsAllZero) {
    EXPECT_EQ(bytesOf(encodeDrive(brakedBlock()).value()), Bytes(kDriveBytes, 0));
}

TEST(Drive, EveryBlockComesBackAsItWas) {
    std::mt19937 random(2);
    for (int i = 0; i < 50'000; ++i) {
        const DriveBlock block = randomDrive(random);
        const auto encoded = encodeDrive(block);
        ASSERT_TRUE(encoded.has_value());
        ASSERT_EQ(decodeDrive(*encoded).value(), block);
        ASSERT_FALSE(hasReservedDriveBits(*encoded));
    }
}

TEST(Drive, EverySpeedOfEveryWheelKeepsItsSign) {
    for (std::size_t wheel = 0; wheel < kWheelCount; ++wheel) {
        for (int speed = -kMaxWheel; speed <= kMaxWheel; ++speed) {
            DriveBlock block;
            block.wheels[wheel] = static_cast<std::int16_t>(speed);
            ASSERT_EQ(decodeDrive(encodeDrive(block).value()).value(), block) << wheel << ' ' << speed;
        }
    }
}

TEST(Drive, EncoderRefusesWhatHasNoPlaceAndNamesIt) {
    const char* const names[] = {"wheel1", "wheel2", "wheel3", "wheel4"};
    for (std::size_t wheel = 0; wheel < kWheelCount; ++wheel) {
        for (const int speed : {-1024, 1024, -32768, 32767}) {
            DriveBlock block;
            block.wheels[wheel] = static_cast<std::int16_t>(speed);
            const auto encoded = encodeDrive(block);
            expectFault(encoded, WireFault::OutOfRange, names[wheel]);
            EXPECT_EQ(encoded.error().got, speed);
            EXPECT_EQ(encoded.error().lowest, -1023);
            EXPECT_EQ(encoded.error().highest, 1023);
        }
    }
    DriveBlock block;
    block.testClass = 8;
    expectFault(encodeDrive(block), WireFault::OutOfRange, "test_class");
    block = {};
    block.testTarget = 255;
    expectFault(encodeDrive(block), WireFault::OutOfRange, "test_target");
    block = {};
    block.autokick.t1 = 128;
    expectFault(encodeDrive(block), WireFault::OutOfRange, "t1");
    block = {};
    block.autokick.t2 = 128;
    expectFault(encodeDrive(block), WireFault::OutOfRange, "t2");
    block = {};
    block.autokick.dt = 128;
    expectFault(encodeDrive(block), WireFault::OutOfRange, "dt");
}

TEST(Drive, DecoderReportsTheIllegalSpeed) {
    // −1024 in wheel 1: bits 8-18 are 100 0000 0000.
    const auto decoded = decodeDrive(hex("80 80 00 00 00 00 00 00 00 00"));
    expectFault(decoded, WireFault::BadValue, "wheel1");
    EXPECT_EQ(decoded.error().got, -1024);
}

TEST(Drive, ReservedBitsAreIgnoredButSeen) {
    for (const char* const text : {"82 00 00 00 00 00 00 00 00 00", "81 00 00 00 00 00 00 00 00 00",
                                   "80 00 00 00 00 00 00 00 00 01"}) {
        EXPECT_EQ(decodeDrive(hex(text)).value(), running()) << text;
        EXPECT_TRUE(hasReservedDriveBits(hex(text))) << text;
    }
    EXPECT_FALSE(hasReservedDriveBits(hex("fc ff")));
}

TEST(Drive, AnyOtherLengthIsRefused) {
    for (std::size_t length = 0; length <= 70; ++length) {
        if (length == kDriveBytes) continue;
        expectFault(decodeDrive(Bytes(length)),
                    length < kDriveBytes ? WireFault::TooShort : WireFault::TooLong, "length");
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
