#include "core/telemetry/store.h"

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using namespace std::chrono_literals;

TEST(TelemetryStore, MakesASeriesOnFirstUse) {
    TelemetryStore store({.series = 4, .samples = 100, .marks = 10});
    EXPECT_EQ(store.find({3, 1}), nullptr);
    TimeSeries* made = store.series({3, 1});
    ASSERT_NE(made, nullptr);
    EXPECT_EQ(store.series({3, 1}), made);
    EXPECT_EQ(store.find({3, 1}), made);
    EXPECT_EQ(store.find({1, 3}), nullptr);
    EXPECT_EQ(made->capacity(), 100U);
    EXPECT_EQ(store.bytes(), made->bytes());
}

TEST(TelemetryStore, ListsItsKeysInTheOrderTheyCame) {
    TelemetryStore store({.series = 4, .samples = 100, .marks = 10});
    store.series({5, 0});
    store.series({2, 9});
    store.series({5, 0});
    EXPECT_EQ(store.keys(), (std::vector<SignalId>{{5, 0}, {2, 9}}));
}

TEST(TelemetryStore, RefusesMoreSeriesThanItsLimitAndCountsThem) {
    TelemetryStore store({.series = 2, .samples = 100, .marks = 10});
    EXPECT_TRUE(store.append({0, 0}, TimePoint(1s), 1.0F));
    EXPECT_TRUE(store.append({1, 0}, TimePoint(1s), 1.0F));
    EXPECT_FALSE(store.append({2, 0}, TimePoint(1s), 1.0F));
    EXPECT_EQ(store.series({2, 0}), nullptr);
    EXPECT_EQ(store.size(), 2U);
    EXPECT_EQ(store.refused(), 2U);
    EXPECT_TRUE(store.append({0, 0}, TimePoint(2s), 2.0F)) << "those that are there go on";
}

TEST(TelemetryStore, AGapOfAUnitLeavesTheOthersAlone) {
    TelemetryStore store({.series = 8, .samples = 100, .marks = 10});
    for (const SignalId key : {SignalId{1, 0}, SignalId{1, 1}, SignalId{2, 0}})
        store.append(key, TimePoint(1s), 7.0F);
    store.gap(1, TimePoint(2s));
    EXPECT_FALSE(store.find({1, 0})->at(TimePoint(2s)));
    EXPECT_FALSE(store.find({1, 1})->at(TimePoint(2s)));
    EXPECT_TRUE(store.find({2, 0})->at(TimePoint(2s)));
    store.gapAll(TimePoint(3s));
    EXPECT_FALSE(store.find({2, 0})->at(TimePoint(3s)));
}

TEST(TelemetryStore, KeepsMarks) {
    TelemetryStore store({.series = 1, .samples = 100, .marks = 10});
    store.mark({TimePoint(1s), MarkKind::Stop, kNoUnit, 1.0F});
    const auto marks = store.marks().between(TimePoint(0s), TimePoint(2s));
    ASSERT_TRUE(marks);
    ASSERT_EQ(marks->size(), 1U);
    EXPECT_EQ(marks->front().kind, MarkKind::Stop);
}

}  // namespace
}  // namespace kickstand
