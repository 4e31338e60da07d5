#include "core/thunderbots/wire/kick.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

TEST(Kick, EveryMessageComesBackAsItWas) {
    std::mt19937 random(3);
    for (int i = 0; i < 20'000; ++i) {
        const KickTimes times = randomTimes(random);
        ASSERT_EQ(decodeKick(encodeKick(times).value()).value(), times);
    }
}

TEST(Kick, FlagsAreTheHighBitsOfTheTimes) {
    EXPECT_EQ(bytesOf(encodeKick({true, false, 1, 2, 3}).value()), hex("81 02 03"));
    EXPECT_EQ(bytesOf(encodeKick({false, true, 127, 127, 127}).value()), hex("7f ff 7f"));
}

TEST(Kick, TimesPast127AreRefusedByName) {
    expectFault(encodeKick({false, false, 128, 0, 0}), WireFault::OutOfRange, "t1");
    expectFault(encodeKick({false, false, 0, 200, 0}), WireFault::OutOfRange, "t2");
    expectFault(encodeKick({false, false, 0, 0, 255}), WireFault::OutOfRange, "dt");
}

TEST(Kick, TheReservedBitIsIgnored) {
    EXPECT_EQ(decodeKick(hex("81 02 83")).value(), (KickTimes{true, false, 1, 2, 3}));
}

TEST(Kick, AnyOtherLengthIsRefused) {
    expectFault(decodeKick({}), WireFault::TooShort, "length");
    expectFault(decodeKick(hex("81 02")), WireFault::TooShort, "length");
    expectFault(decodeKick(hex("81 02 03 04")), WireFault::TooLong, "length");
}

TEST(Kick, AutokickIsDisarmedByThreeZeroTimesWhateverTheFlags) {
    EXPECT_TRUE(isNoAutokick({true, true, 0, 0, 0}));
    EXPECT_FALSE(isNoAutokick({false, false, 1, 0, 0}));
    EXPECT_FALSE(isNoAutokick({false, false, 0, 1, 0}));
    EXPECT_FALSE(isNoAutokick({false, false, 0, 0, 1}));
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
