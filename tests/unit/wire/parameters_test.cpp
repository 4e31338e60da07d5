#include "core/thunderbots/wire/parameters.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

TEST(Parameters, TheTailIsKeptAndTheLengthComesBack) {
    std::mt19937 random(6);
    for (std::size_t length = kDefinedParameterBytes; length <= kMaxParameterBytes; ++length) {
        const Bytes block = randomBytes(random, length);
        const auto parameters = decodeParameters(block);
        ASSERT_TRUE(parameters.has_value()) << length;
        EXPECT_EQ(parameters->tail.size(), length - kDefinedParameterBytes);
        EXPECT_EQ(bytesOf(encodeParameters(*parameters)), block);
    }
}

TEST(Parameters, FieldsStandInTheOrderOfTheReference) {
    const auto parameters = decodeParameters(hex("01 0e 0f 07 c0 00")).value();
    EXPECT_EQ(parameters.flash(), FlashContents::Microcontroller);
    EXPECT_EQ(parameters.channel0, 0x0E);
    EXPECT_EQ(parameters.channel1, 0x0F);
    EXPECT_EQ(parameters.robotNumber, 7);
    EXPECT_EQ(parameters.dribblerDuty, 0xC0);
    EXPECT_EQ(bytesOf(parameters.tail), hex("00"));
}

TEST(Parameters, AnyUnknownFlashContentsMeanNoData) {
    OperationalParameters parameters;
    parameters.flashContents = 0;
    EXPECT_EQ(parameters.flash(), FlashContents::FpgaBitstream);
    for (const int value : {2, 77, 255}) {
        parameters.flashContents = static_cast<std::uint8_t>(value);
        EXPECT_EQ(parameters.flash(), FlashContents::NoData) << value;
    }
}

TEST(Parameters, LengthsThatNoMessageCarriesAreRefused) {
    for (std::size_t length = 0; length < kDefinedParameterBytes; ++length) {
        expectFault(decodeParameters(Bytes(length)), WireFault::TooShort, "length");
    }
    expectFault(decodeParameters(Bytes(kMaxParameterBytes + 1)), WireFault::TooLong, "length");
}

TEST(Parameters, IllegalValuesAreReadButDoNotPassTheCheck) {
    EXPECT_TRUE(checkParameters(decodeParameters(hex("ff 00 00 0f ff")).value()).has_value());
    EXPECT_TRUE(checkParameters(decodeParameters(hex("00 0b 1a 00 00")).value()).has_value());
    expectFault(checkParameters(decodeParameters(hex("00 0a 0f 00 00")).value()), WireFault::OutOfRange,
                "channel0");
    expectFault(checkParameters(decodeParameters(hex("00 0e 1b 00 00")).value()), WireFault::OutOfRange,
                "channel1");
    expectFault(checkParameters(decodeParameters(hex("00 0e 0f 10 00")).value()), WireFault::OutOfRange,
                "robot_number");
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
