#include "core/engine/flow/event_ring.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

TEST(EventRing, NumbersEventsFromZero) {
    EventRing<std::string> ring(4);
    EXPECT_EQ(ring.append("a"), 0U);
    EXPECT_EQ(ring.append("b"), 1U);
    EventRing<std::string>::Cursor cursor = 0;
    const auto read = ring.read(cursor);
    ASSERT_EQ(read.events.size(), 2U);
    EXPECT_EQ(read.lost, 0U);
    EXPECT_EQ(read.events[0].value, "a");
    EXPECT_EQ(read.events[1].sequence, 1U);
    EXPECT_EQ(cursor, 2U);
    EXPECT_TRUE(ring.read(cursor).events.empty());
}

TEST(EventRing, ReadersDoNotDisturbEachOther) {
    EventRing<int> ring(8);
    ring.append(1);
    EventRing<int>::Cursor early = 0;
    EventRing<int>::Cursor fromNowOn = ring.end();
    EXPECT_EQ(ring.read(early).events.size(), 1U);
    ring.append(2);
    const auto read = ring.read(fromNowOn);
    ASSERT_EQ(read.events.size(), 1U);
    EXPECT_EQ(read.events[0].value, 2);
    EXPECT_EQ(ring.read(early).events.at(0).value, 2);
}

TEST(EventRing, TellsAReaderThatFellBehindHowMuchItMissed) {
    EventRing<int> ring(4);
    EventRing<int>::Cursor cursor = 0;
    for (int i = 0; i < 3; ++i)
        ring.append(i);
    EXPECT_EQ(ring.read(cursor).events.size(), 3U);
    for (int i = 3; i < 20; ++i)
        ring.append(i);
    const auto read = ring.read(cursor);
    EXPECT_EQ(read.lost, 13U);
    ASSERT_EQ(read.events.size(), 4U);
    EXPECT_EQ(read.events[0].sequence, 16U);
    EXPECT_EQ(read.events[0].value, 16);
    EXPECT_EQ(ring.read(cursor).lost, 0U) << "it is told once";
}

TEST(EventRing, ReadsAsMuchAsIsAskedFor) {
    EventRing<int> ring(100);
    for (int i = 0; i < 50; ++i)
        ring.append(i);
    EventRing<int>::Cursor cursor = 0;
    EXPECT_EQ(ring.read(cursor, 20).events.size(), 20U);
    EXPECT_EQ(ring.read(cursor, 20).events.front().value, 20);
    EXPECT_EQ(ring.read(cursor, 20).events.size(), 10U);
    EXPECT_EQ(ring.read(cursor, 0).events.size(), 0U);
    EXPECT_EQ(cursor, 50U);
}

TEST(EventRing, LetsGoOfWhatItOverwrites) {
    EventRing<std::shared_ptr<int>> ring(2);
    const auto value = std::make_shared<int>(1);
    ring.append(value);
    ring.append(nullptr);
    EXPECT_EQ(value.use_count(), 2);
    ring.append(nullptr);
    EXPECT_EQ(value.use_count(), 1);
}

}  // namespace
}  // namespace kickstand
