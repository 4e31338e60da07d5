#include "core/base/latch.h"

#include <gtest/gtest.h>

namespace kickstand {
namespace {

TEST(StopLatch, KeepsItsFirstReasonUntilReArmed) {
    StopLatch latch;
    EXPECT_FALSE(latch.isSet());
    EXPECT_TRUE(latch.set(StopReason::LinkLost));
    EXPECT_FALSE(latch.set(StopReason::Person));
    EXPECT_EQ(latch.reason(), StopReason::LinkLost);
    latch.rearm();
    EXPECT_FALSE(latch.isSet());
    EXPECT_EQ(latch.reason(), StopReason::None);
}

TEST(StopLatch, CountsHowOftenItWasSetAndRemembersWhy) {
    StopLatch latch;
    for (std::uint64_t i = 1; i <= 1000; ++i) {
        EXPECT_TRUE(latch.set(StopReason::Suspend));
        latch.rearm();
        EXPECT_EQ(latch.stops(), i);
        EXPECT_EQ(latch.lastReason(), StopReason::Suspend);
    }
    latch.rearm();
    EXPECT_EQ(latch.stops(), 1000U);
}

TEST(StopLatch, CountsEveryPressWhileItIsSetToo) {
    StopLatch latch;
    latch.set(StopReason::Person);
    latch.set(StopReason::Person);
    EXPECT_EQ(latch.presses(), 2U);
    EXPECT_EQ(latch.stops(), 1U);
}

}  // namespace
}  // namespace kickstand
