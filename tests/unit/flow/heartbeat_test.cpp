#include "core/engine/flow/heartbeat.h"

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using namespace std::chrono_literals;

TEST(Heartbeat, IsNotFreshBeforeTheFirstBeat) {
    const Heartbeat heartbeat;
    EXPECT_FALSE(heartbeat.fresh(TimePoint(0s), 1s));
    EXPECT_FALSE(heartbeat.fresh(TimePoint::min(), Duration::max()));
    EXPECT_FALSE(heartbeat.last());
}

TEST(Heartbeat, IsFreshUpToTheLimit) {
    Heartbeat heartbeat;
    heartbeat.beat(TimePoint(10s));
    EXPECT_TRUE(heartbeat.fresh(TimePoint(10s), 300ms));
    EXPECT_TRUE(heartbeat.fresh(TimePoint(10s + 300ms), 300ms));
    EXPECT_FALSE(heartbeat.fresh(TimePoint(10s + 300ms + 1ns), 300ms));
    heartbeat.beat(TimePoint(11s));
    EXPECT_TRUE(heartbeat.fresh(TimePoint(11s), 300ms));
}

TEST(Heartbeat, TheLatestBeatCounts) {
    Heartbeat heartbeat;
    heartbeat.beat(TimePoint(10s));
    heartbeat.beat(TimePoint(9s));
    EXPECT_EQ(heartbeat.last(), TimePoint(10s));
    EXPECT_TRUE(heartbeat.fresh(TimePoint(9s), 0s)) << "a beat from after now is fresh";
}

TEST(Heartbeat, WithdrawnIsNotFreshUntilTheNextBeat) {
    Heartbeat heartbeat;
    heartbeat.beat(TimePoint(10s));
    heartbeat.withdraw();
    EXPECT_FALSE(heartbeat.fresh(TimePoint(10s), 1s));
    heartbeat.beat(TimePoint(9s));
    EXPECT_TRUE(heartbeat.fresh(TimePoint(10s), 1s));
}

}  // namespace
}  // namespace kickstand
