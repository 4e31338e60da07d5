#include "core/telemetry/marks.h"

#include <array>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using namespace std::chrono_literals;

Mark mark(Duration time, MarkKind kind, std::uint16_t unit = kNoUnit, float value = 0) {
    return {TimePoint(time), kind, unit, value};
}

TEST(Marks, ComeBackAsTheyWereMade) {
    Marks marks(100);
    const std::array made{mark(1s, MarkKind::LinkUp), mark(2s, MarkKind::Kick, 3, 2400.0F),
                          mark(3s, MarkKind::DeviceError, 15, -0.5F), mark(3s, MarkKind::UnitLost, 15)};
    for (const Mark& each : made)
        marks.append(each);
    std::array<Mark, 10> out;
    const RingCopy copied = marks.copy(0, out);
    ASSERT_EQ(copied.count, made.size());
    EXPECT_EQ(copied.lost, 0U);
    EXPECT_TRUE(std::equal(made.begin(), made.end(), out.begin()));
}

TEST(Marks, BetweenTakesTheBeginningAndLeavesTheEnd) {
    Marks marks(100);
    for (int i = 0; i < 10; ++i)
        marks.append(mark(i * 1s, MarkKind::Autokick, static_cast<std::uint16_t>(i)));
    const auto found = marks.between(TimePoint(3s), TimePoint(6s));
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 3U);
    EXPECT_EQ(found->front().unit, 3);
    EXPECT_EQ(found->back().unit, 5);
    EXPECT_TRUE(marks.between(TimePoint(6s), TimePoint(3s))->empty());
}

TEST(Marks, TheOldestAreForgottenAndCountedAsLost) {
    Marks marks(50);
    for (int i = 0; i < 400; ++i)
        marks.append(mark(i * 1s, MarkKind::Kick, 0, static_cast<float>(i)));
    EXPECT_EQ(marks.total(), 400U);
    const auto found = marks.between(TimePoint(0s), TimePoint(1000s));
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 50U);
    EXPECT_EQ(found->front().value, 350.0F);
    std::array<Mark, 10> out;
    EXPECT_EQ(marks.copy(100, out).lost, 250U);
}

TEST(Marks, StayInOrderOfTime) {
    Marks marks(50);
    marks.append(mark(5s, MarkKind::Stop));
    marks.append(mark(4s, MarkKind::Rearmed));
    const auto found = marks.between(TimePoint(5s), TimePoint(6s));
    ASSERT_EQ(found->size(), 2U);
    EXPECT_EQ(found->back().kind, MarkKind::Rearmed);
    EXPECT_EQ(found->back().time, TimePoint(5s));
}

}  // namespace
}  // namespace kickstand
