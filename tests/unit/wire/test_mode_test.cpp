#include "core/thunderbots/wire/test_mode.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

TEST(TestModeMessage, IsClassAndTarget) {
    EXPECT_EQ(bytesOf(encodeTestMode({TestClass::Hall, 5}).value()), hex("02 05"));
    EXPECT_EQ(decodeTestMode(hex("03 04")).value(), (TestMode{TestClass::Encoder, 4}));
}

TEST(TestModeMessage, EveryPairIsTakenBothWaysOrRefusedBothWays) {
    for (int number = 0; number < 256; ++number) {
        for (int target = 0; target < 256; ++target) {
            const Bytes bytes{static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(target)};
            const TestMode mode{static_cast<TestClass>(number), bytes[1]};
            const auto decoded = decodeTestMode(bytes);
            const auto encoded = encodeTestMode(mode);
            ASSERT_EQ(decoded.has_value(), encoded.has_value()) << number << ' ' << target;
            if (!decoded) continue;
            ASSERT_EQ(*decoded, mode);
            ASSERT_EQ(bytesOf(*encoded), bytes);
        }
    }
}

TEST(TestModeMessage, TargetsBelongToTheirClass) {
    expectFault(encodeTestMode({TestClass::Hall, 0}), WireFault::OutOfRange, "target");
    expectFault(encodeTestMode({TestClass::Hall, 6}), WireFault::OutOfRange, "target");
    expectFault(encodeTestMode({TestClass::Encoder, 5}), WireFault::OutOfRange, "target");
    expectFault(decodeTestMode(hex("04 00")), WireFault::BadValue, "target");
    EXPECT_TRUE(encodeTestMode({TestClass::Lamp, 0}).has_value());
    EXPECT_TRUE(decodeTestMode(hex("05 04")).has_value()) << "the charger test has no targets to be wrong";
}

TEST(TestModeMessage, UndefinedClassesAreRefused) {
    expectFault(decodeTestMode(hex("06 01")), WireFault::BadValue, "class");
    expectFault(encodeTestMode({static_cast<TestClass>(6), 1}), WireFault::OutOfRange, "class");
}

TEST(TestModeMessage, AnyOtherLengthIsRefused) {
    expectFault(decodeTestMode({}), WireFault::TooShort, "length");
    expectFault(decodeTestMode(hex("01")), WireFault::TooShort, "length");
    expectFault(decodeTestMode(hex("01 00 00")), WireFault::TooLong, "length");
}

TEST(TestModeMessage, NamesAreStableAndLeadBack) {
    const char* const names[] = {"none", "lamp", "hall", "encoder", "encoder-count", "charger"};
    for (std::uint8_t number = 0; number < kTestClassCount; ++number) {
        EXPECT_STREQ(name(static_cast<TestClass>(number)), names[number]);
        EXPECT_EQ(testClassFromName(names[number]), static_cast<TestClass>(number));
        EXPECT_EQ(testClassFromNumber(number), static_cast<TestClass>(number));
    }
    EXPECT_EQ(testClassFromName("Lamp"), std::nullopt);
    EXPECT_EQ(testClassFromNumber(6), std::nullopt);
    EXPECT_STREQ(name(static_cast<TestClass>(77)), "undefined");
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
