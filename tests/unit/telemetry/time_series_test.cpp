#include "core/telemetry/time_series.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint at(Duration sinceStart) {
    return TimePoint(sinceStart);
}

std::vector<Sample> all(const TimeSeries& series) {
    std::vector<Sample> samples(series.capacity());
    samples.resize(series.copy(0, samples).count);
    return samples;
}

TEST(TimeSeries, IsEmptyAtFirst) {
    const TimeSeries series(100);
    EXPECT_EQ(series.total(), 0U);
    EXPECT_EQ(series.available().error(), Miss::NoValue);
    EXPECT_EQ(series.at(at(1s)).error(), Miss::NoValue);
    EXPECT_EQ(series.nearest(at(1s)).error(), Miss::NoValue);
    EXPECT_EQ(series.stats(at(0s), at(1s)).error(), Miss::NoValue);
    std::array<Column, 2> columns;
    ASSERT_TRUE(series.columns(at(0s), 1s, columns));
    EXPECT_TRUE(std::isnan(columns[0].min));
    EXPECT_TRUE(std::isnan(columns[1].last));
}

TEST(TimeSeries, AValueHoldsUntilTheNextOne) {
    TimeSeries series(100);
    series.append(at(1s), 15.5F);
    series.append(at(3s), 16.0F);
    EXPECT_EQ(series.at(at(1s - 1ns)).error(), Miss::NoValue);
    EXPECT_EQ(series.at(at(1s))->value, 15.5F);
    EXPECT_EQ(series.at(at(3s - 1ns))->value, 15.5F);
    EXPECT_EQ(series.at(at(3s - 1ns))->time, at(1s));
    EXPECT_EQ(series.at(at(3s))->value, 16.0F);
    EXPECT_EQ(series.at(TimePoint::max())->value, 16.0F);
}

TEST(TimeSeries, KeepsChangesOnly) {
    TimeSeries series(100);
    EXPECT_TRUE(series.append(at(1s), 2.0F));
    EXPECT_FALSE(series.append(at(2s), 2.0F));
    EXPECT_TRUE(series.append(at(3s), 4.0F));
    EXPECT_EQ(series.total(), 2U);
    EXPECT_EQ(series.at(at(2s))->time, at(1s));
}

TEST(TimeSeries, AGapHoldsNothing) {
    TimeSeries series(100);
    EXPECT_FALSE(series.gap(at(0s))) << "before the first value there is nothing to end";
    series.append(at(1s), 2.0F);
    EXPECT_TRUE(series.gap(at(2s)));
    EXPECT_FALSE(series.gap(at(3s)));
    EXPECT_EQ(series.at(at(2s)).error(), Miss::NoValue);
    EXPECT_EQ(series.at(at(9s)).error(), Miss::NoValue);
    EXPECT_TRUE(series.append(at(4s), 2.0F)) << "the same value, known again";
    EXPECT_EQ(series.at(at(4s))->value, 2.0F);
    EXPECT_EQ(series.total(), 3U);
}

TEST(TimeSeries, ValuesThatAreNotFiniteAreGaps) {
    for (const float value : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN()}) {
        TimeSeries series(100);
        series.append(at(1s), 2.0F);
        EXPECT_TRUE(series.append(at(2s), value));
        EXPECT_EQ(series.at(at(2s)).error(), Miss::NoValue);
        EXPECT_EQ(series.stats(at(0s), at(9s))->max, 2.0F);
    }
}

TEST(TimeSeries, ATimeOutOfOrderIsTakenAsTheLastOneAndCounted) {
    TimeSeries series(100);
    series.append(at(5s), 1.0F);
    series.append(at(4s), 2.0F);
    series.append(at(6s), 3.0F);
    EXPECT_EQ(series.outOfOrder(), 1U);
    const auto samples = all(series);
    ASSERT_EQ(samples.size(), 3U);
    EXPECT_EQ(samples[1].time, at(5s));
    EXPECT_EQ(samples[1].value, 2.0F);
    EXPECT_EQ(series.at(at(5s))->value, 2.0F);
}

TEST(TimeSeries, ForgetsTheOldestAndSaysSo) {
    TimeSeries series(100);
    for (int i = 0; i < 1000; ++i)
        series.append(at(i * 1s), static_cast<float>(i));
    EXPECT_EQ(series.total(), 1000U);
    const auto range = series.available();
    ASSERT_TRUE(range);
    EXPECT_EQ(range->firstIndex, 900U);
    EXPECT_EQ(range->endIndex, 1000U);
    EXPECT_EQ(range->first, at(900s));
    EXPECT_EQ(range->last, at(999s));
    EXPECT_EQ(series.at(at(899s)).error(), Miss::NoValue);
    EXPECT_EQ(series.at(at(900s))->value, 900.0F);

    std::array<Sample, 200> out;
    const RingCopy copied = series.copy(850, out);
    EXPECT_EQ(copied.lost, 50U);
    EXPECT_EQ(copied.count, 100U);
    EXPECT_EQ(copied.next, 1000U);
    EXPECT_EQ(out[0].value, 900.0F);
}

TEST(TimeSeries, TakesNoMoreMemoryThanItReservedAtFirst) {
    TimeSeries series(131'000);
    const std::size_t before = series.bytes();
    EXPECT_LE(before, 131'072 * 27 / 2);
    for (int i = 0; i < 300'000; ++i)
        series.append(at(i * 1ms), static_cast<float>(i % 1000));
    EXPECT_EQ(series.bytes(), before);
    EXPECT_EQ(series.available()->endIndex - series.available()->firstIndex, 131'000U);
}

TEST(TimeSeries, NearestLooksBothWays) {
    TimeSeries series(100);
    series.append(at(10s), 1.0F);
    series.append(at(20s), 2.0F);
    EXPECT_EQ(series.nearest(at(0s))->time, at(10s));
    EXPECT_EQ(series.nearest(at(14s))->time, at(10s));
    EXPECT_EQ(series.nearest(at(16s))->time, at(20s));
    EXPECT_EQ(series.nearest(TimePoint::min())->time, at(10s));
    EXPECT_EQ(series.nearest(TimePoint::max())->time, at(20s));
}

TEST(TimeSeries, NearestLeavesOutTheBeginningsOfGaps) {
    TimeSeries series(100);
    series.append(at(10s), 1.0F);
    series.gap(at(20s));
    series.append(at(100s), 2.0F);
    series.gap(at(110s));
    EXPECT_EQ(series.nearest(at(21s))->time, at(10s));
    EXPECT_EQ(series.nearest(at(90s))->time, at(100s));
    EXPECT_EQ(series.nearest(at(500s))->time, at(100s));
}

TEST(TimeSeries, AColumnHasWhatCameInWithIt) {
    TimeSeries series(100);
    series.append(at(0s), 5.0F);
    series.append(at(1500ms), 1.0F);
    series.append(at(1600ms), 9.0F);
    series.append(at(1700ms), 3.0F);
    std::array<Column, 4> columns;
    ASSERT_TRUE(series.columns(at(-1s), 1s, columns));

    EXPECT_TRUE(std::isnan(columns[0].min));
    EXPECT_EQ(columns[0].count, 0U);
    EXPECT_EQ(columns[1].first, 5.0F) << "a change at the very beginning of a column is its first value";
    EXPECT_EQ(columns[1].count, 1U);
    EXPECT_EQ(columns[2].first, 5.0F);
    EXPECT_EQ(columns[2].min, 1.0F);
    EXPECT_EQ(columns[2].max, 9.0F);
    EXPECT_EQ(columns[2].last, 3.0F);
    EXPECT_EQ(columns[2].count, 3U);
    EXPECT_EQ(columns[3].min, 3.0F) << "the last value holds on";
    EXPECT_EQ(columns[3].max, 3.0F);
    EXPECT_EQ(columns[3].count, 0U);
}

TEST(TimeSeries, AColumnShowsFromWhichSideAGapReachesIn) {
    TimeSeries series(100);
    series.append(at(500ms), 2.0F);
    series.gap(at(1500ms));
    series.append(at(3500ms), 4.0F);
    std::array<Column, 4> columns;
    ASSERT_TRUE(series.columns(at(0s), 1s, columns));

    EXPECT_TRUE(std::isnan(columns[0].first));
    EXPECT_EQ(columns[0].last, 2.0F);
    EXPECT_EQ(columns[1].first, 2.0F);
    EXPECT_TRUE(std::isnan(columns[1].last));
    EXPECT_EQ(columns[1].max, 2.0F);
    EXPECT_TRUE(std::isnan(columns[2].min));
    EXPECT_TRUE(std::isnan(columns[3].first));
    EXPECT_EQ(columns[3].last, 4.0F);
}

TEST(TimeSeries, AColumnIsNeverNarrowerThanANanosecond) {
    TimeSeries series(100);
    series.append(at(0ns), 1.0F);
    series.append(at(1ns), 2.0F);
    std::array<Column, 2> columns;
    ASSERT_TRUE(series.columns(at(0ns), 0ns, columns));
    EXPECT_EQ(columns[0].last, 1.0F);
    EXPECT_EQ(columns[1].first, 2.0F);
    EXPECT_TRUE(series.columns(at(0ns), 1s, {}));
}

TEST(TimeSeries, TheMeanIsWeightedByTime) {
    TimeSeries series(100);
    series.append(at(0s), 10.0F);
    series.append(at(9s), 20.0F);
    const auto stats = series.stats(at(0s), at(10s));
    ASSERT_TRUE(stats);
    EXPECT_DOUBLE_EQ(stats->mean, 11.0);
    EXPECT_EQ(stats->min, 10.0F);
    EXPECT_EQ(stats->max, 20.0F);
    EXPECT_EQ(stats->held, 10s);
    EXPECT_EQ(stats->count, 2U);
}

TEST(TimeSeries, StatsLeaveGapsOut) {
    TimeSeries series(100);
    series.append(at(0s), 10.0F);
    series.gap(at(1s));
    series.append(at(8s), 40.0F);
    const auto stats = series.stats(at(-5s), at(10s));
    ASSERT_TRUE(stats);
    EXPECT_DOUBLE_EQ(stats->mean, 30.0);
    EXPECT_EQ(stats->held, 3s);
    EXPECT_EQ(series.stats(at(2s), at(7s)).error(), Miss::NoValue);
}

TEST(TimeSeries, StatsOfAnEmptySpanAreNone) {
    TimeSeries series(100);
    series.append(at(0s), 10.0F);
    EXPECT_EQ(series.stats(at(5s), at(5s)).error(), Miss::NoValue);
    EXPECT_EQ(series.stats(at(5s), at(4s)).error(), Miss::NoValue);
    EXPECT_DOUBLE_EQ(series.stats(at(5s), at(5s + 1ns))->mean, 10.0);
}

}  // namespace
}  // namespace kickstand
