#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/telemetry/time_series.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint at(Duration sinceStart) {
    return TimePoint(sinceStart);
}

/// A series that forgets soon, beside one that forgets nothing.
struct Pair {
    TimeSeries forgetful{400, 500};
    TimeSeries whole{100'000};

    void append(TimePoint time, float value) {
        forgetful.append(time, value);
        whole.append(time, value);
    }
};

/// Two minutes of noise around a slow ramp, 100 changes a second.
void fill(Pair& pair) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> noise(-1, 1);
    for (int i = 0; i < 12'000; ++i)
        pair.append(at(i * 10ms), static_cast<float>(i) / 100 + noise(random));
}

TEST(PastBlocks, ColumnsReachBackBeyondTheRing) {
    Pair pair;
    fill(pair);
    ASSERT_GT(pair.forgetful.available()->first, at(115s));
    EXPECT_EQ(pair.forgetful.available()->coarse, at(0s));
    std::array<Column, 24> coarse;
    std::array<Column, 24> exact;
    ASSERT_TRUE(pair.forgetful.columns(at(0s), 5s, coarse));
    ASSERT_TRUE(pair.whole.columns(at(0s), 5s, exact));
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        // To the resolution of a block: nothing is left out, and at most a second's worth is added.
        EXPECT_LE(coarse.at(i).min, exact.at(i).min) << i;
        EXPECT_GE(coarse.at(i).max, exact.at(i).max) << i;
        EXPECT_NEAR(coarse.at(i).min, exact.at(i).min, 3) << i;
        EXPECT_NEAR(coarse.at(i).max, exact.at(i).max, 3) << i;
        EXPECT_NEAR(coarse.at(i).last, exact.at(i).last, 4) << i;
    }
}

TEST(PastBlocks, TheRingItselfStaysExact) {
    Pair pair;
    fill(pair);
    const TimePoint first = pair.forgetful.available()->first;
    std::array<Column, 100> near;
    std::array<Column, 100> exact;
    ASSERT_TRUE(pair.forgetful.columns(first + 10ms, 30ms, near));
    ASSERT_TRUE(pair.whole.columns(first + 10ms, 30ms, exact));
    for (std::size_t i = 0; i < near.size(); ++i) {
        EXPECT_EQ(near.at(i).min, exact.at(i).min) << i;
        EXPECT_EQ(near.at(i).max, exact.at(i).max) << i;
        EXPECT_EQ(near.at(i).count, exact.at(i).count) << i;
    }
}

TEST(PastBlocks, StatisticsReachBackToo) {
    Pair pair;
    fill(pair);
    for (const auto& [from, to] :
         std::vector<std::pair<Duration, Duration>>{{10s, 20s}, {30s, 119s}, {118s, 119s}}) {
        const auto coarse = pair.forgetful.stats(at(from), at(to));
        const auto exact = pair.whole.stats(at(from), at(to));
        ASSERT_TRUE(coarse && exact);
        EXPECT_NEAR(coarse->mean, exact->mean, 0.15);
        EXPECT_NEAR(seconds(coarse->held), seconds(exact->held), 1.1);
        EXPECT_NEAR(coarse->min, exact->min, 3);
        EXPECT_NEAR(coarse->max, exact->max, 3);
    }
}

TEST(PastBlocks, AGapIsStillAGapWhenItIsLongPast) {
    Pair pair;
    for (int i = 0; i < 1'000; ++i)
        pair.append(at(i * 10ms), static_cast<float>(i % 7));
    pair.append(at(10s), kNoValue);
    for (int i = 0; i < 1'000; ++i)
        pair.append(at(100s + i * 10ms), static_cast<float>(i % 7));
    std::array<Column, 8> columns;
    ASSERT_TRUE(pair.forgetful.columns(at(15s), 10s, columns));
    for (const Column& column : columns) {
        EXPECT_TRUE(std::isnan(column.min));
        EXPECT_TRUE(std::isnan(column.last));
    }
    EXPECT_EQ(pair.forgetful.at(at(50s)).error(), Miss::NoValue);
    EXPECT_FALSE(pair.forgetful.stats(at(15s), at(90s)));
}

TEST(PastBlocks, AValueThatHeldForLongIsNotSmearedOverWhatCameBefore) {
    Pair pair;
    for (int i = 0; i < 50; ++i)
        pair.append(at(i * 10ms), static_cast<float>(i % 2) * 100);
    pair.append(at(500ms), 7);
    for (int i = 0; i < 1'000; ++i)
        pair.append(at(100s + i * 10ms), static_cast<float>(i % 3));
    std::array<Column, 4> columns;
    ASSERT_TRUE(pair.forgetful.columns(at(20s), 10s, columns));
    for (const Column& column : columns) {
        EXPECT_EQ(column.min, 7);
        EXPECT_EQ(column.max, 7);
    }
    EXPECT_EQ(pair.forgetful.at(at(50s))->value, 7);
}

TEST(PastBlocks, TheOldestBlocksGiveWay) {
    TimeSeries series(100, 10);
    for (int i = 0; i < 10'000; ++i)
        series.append(at(i * 10ms), static_cast<float>(i % 5));
    // A block holds a quarter of the ring at most.
    EXPECT_NEAR(seconds(series.available()->coarse - at(0s)), 100 - 0.25 * 10, 0.6);
    std::array<Column, 1> columns;
    ASSERT_TRUE(series.columns(at(10s), 1s, columns));
    EXPECT_TRUE(std::isnan(columns[0].min));
}

}  // namespace
}  // namespace kickstand
