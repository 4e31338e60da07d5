#include "core/thunderbots/wire/feedback.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

FeedbackBlock randomFeedback(std::mt19937& random) {
    const auto bit = [&] { return between(random, 0, 1) == 1; };
    const auto adc = [&](int highest) { return static_cast<std::uint16_t>(between(random, 0, highest)); };
    return {bit(), bit(), bit(), bit(), adc(kMaxAdc10), adc(kMaxAdc12), adc(kMaxAdc10), adc(kMaxAdc10)};
}

TEST(Feedback, ReadingsAreLittleEndianBehindTheFlags) {
    const FeedbackBlock block{true, true, false, true, 0x0123, 0x0ABC, 0x0234, 0x0345};
    EXPECT_EQ(bytesOf(encodeFeedback(block).value()), hex("0b 23 01 bc 0a 34 02 45 03"));
    EXPECT_EQ(decodeFeedback(hex("0b 23 01 bc 0a 34 02 45 03")).value(), block);
}

TEST(Feedback, EveryBlockComesBackAsItWas) {
    std::mt19937 random(5);
    for (int i = 0; i < 20'000; ++i) {
        const FeedbackBlock block = randomFeedback(random);
        ASSERT_EQ(decodeFeedback(encodeFeedback(block).value()).value(), block);
    }
}

TEST(Feedback, ReservedFlagsAreIgnored) {
    EXPECT_EQ(decodeFeedback(hex("f0 00 00 00 00 00 00 00 00")).value(), FeedbackBlock{});
}

TEST(Feedback, AReadingThatItsConverterCannotGiveIsNamed) {
    expectFault(decodeFeedback(hex("01 00 04 00 00 00 00 00 00")), WireFault::BadValue, "battery");
    expectFault(decodeFeedback(hex("01 00 00 00 10 00 00 00 00")), WireFault::BadValue, "capacitor");
    expectFault(decodeFeedback(hex("01 00 00 00 00 ff ff 00 00")), WireFault::BadValue, "thermistor");
    expectFault(decodeFeedback(hex("01 00 00 00 00 00 00 00 80")), WireFault::BadValue, "light");
    EXPECT_TRUE(decodeFeedback(hex("01 ff 03 ff 0f ff 03 ff 03")).has_value());
    FeedbackBlock block;
    block.capacitor_adc = 4096;
    const auto encoded = encodeFeedback(block);
    expectFault(encoded, WireFault::OutOfRange, "capacitor");
    EXPECT_EQ(encoded.error().highest, 4095);
    EXPECT_EQ(encoded.error().got, 4096);
}

TEST(Feedback, AnyOtherLengthIsRefused) {
    for (std::size_t length = 0; length <= 70; ++length) {
        if (length == kFeedbackBytes) continue;
        expectFault(decodeFeedback(Bytes(length)),
                    length < kFeedbackBytes ? WireFault::TooShort : WireFault::TooLong, "length");
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
