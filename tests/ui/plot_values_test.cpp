// Values on the screen: ranges, rows, pixels, ticks, labels, triggers, tables.

#include <QSet>
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "ui/plot/curve_colours.h"
#include "ui/plot/plot_painter.h"
#include "ui/plot/seen_csv.h"
#include "ui/plot/span_image.h"
#include "ui/plot/time_ticks.h"
#include "ui/plot/trigger.h"
#include "ui/plot/value_range.h"

namespace kickstand::ui {
namespace {

using namespace std::chrono_literals;

TEST(ValueRange, ZoomingKeepsTheValueUnderThePointer) {
    const ValueRange range{10, 20};
    const ValueRange closer = zoomed(range, 0.5, 12);
    EXPECT_DOUBLE_EQ(closer.low, 11);
    EXPECT_DOUBLE_EQ(closer.high, 16);
    const ValueRange back = zoomed(closer, 2, 12);
    EXPECT_NEAR(back.low, range.low, 1e-9);
    EXPECT_NEAR(back.high, range.high, 1e-9);
}

TEST(ValueRange, NeverBecomesTooSmallOrTooLarge) {
    ValueRange range{0, 250};
    for (int i = 0; i < 200; ++i)
        range = zoomed(range, 0.5, 200);
    EXPECT_GT(static_cast<float>(range.high) - static_cast<float>(range.low), 0);
    for (int i = 0; i < 200; ++i)
        range = zoomed(range, 2, 200);
    for (int i = 0; i < 200; ++i)
        range = moved(range, 1);
    EXPECT_LE(range.high, 1e8);
}

TEST(ValueRange, IsWidenedInStepsAndOnlyWhereNeeded) {
    const ValueRange usual{0, 250};
    EXPECT_EQ(widened(usual, 10, 240), usual);
    EXPECT_EQ(widened(usual, 10, 251), (ValueRange{0, 275}));
    EXPECT_EQ(widened(usual, -30, 251), (ValueRange{-50, 275}));
}

TEST(ValueRange, FitsWithAirAndKeepsALeastHeight) {
    const ValueRange flat = around(15, 15, 1);
    EXPECT_DOUBLE_EQ(flat.size(), 1);
    EXPECT_DOUBLE_EQ((flat.low + flat.high) / 2, 15);
    const ValueRange wide = around(0, 100, 1);
    EXPECT_LT(wide.low, 0);
    EXPECT_GT(wide.high, 100);
}

TEST(ValueRows, ZeroIsTheUpperEnd) {
    const ValueRows rows({0, 10}, 11);
    EXPECT_EQ(rows.rowOf(10), 0);
    EXPECT_EQ(rows.rowOf(0), 10);
    EXPECT_EQ(rows.rowOf(5), 5);
    EXPECT_LT(rows.rowOf(20), 0);
    EXPECT_GT(rows.rowOf(-1e30F), 10);
}

class SpanImageTest : public testing::Test {
  protected:
    static constexpr QRgb kRed = 0xffff0000;
    static constexpr QRgb kBlue = 0xff0000ff;

    static Column column(float min, float max) { return {min, max, min, max, 1}; }
    int lit(int place, QRgb colour) const {
        int count = 0;
        for (int row = 0; row < image.rows(); ++row)
            count += image.pixel(place, row) == colour ? 1 : 0;
        return count;
    }

    SpanImage image;
    ValueRows rows{{0, 10}, 11};
};

TEST_F(SpanImageTest, AColumnIsFilledFromLeastToGreatestAndAGapIsEmpty) {
    image.resize(40, 11, 1, 1);
    std::vector<Column> columns(40, column(2, 4));
    columns[20] = Column{};
    image.draw(0, std::vector<DrawnSpan>{{kRed, columns}}, rows);
    for (int place = 0; place < 40; ++place)
        EXPECT_EQ(lit(place, kRed), place == 20 ? 0 : 3) << place;
    EXPECT_EQ(image.pixel(5, 6), kRed);
    EXPECT_EQ(image.pixel(5, 8), kRed);
    EXPECT_EQ(image.pixel(5, 9), 0U);
}

TEST_F(SpanImageTest, DrawingAgainWipesWhatWasThere) {
    image.resize(4, 11, 1, 1);
    const std::vector<Column> before(4, column(0, 10));
    image.draw(0, std::vector<DrawnSpan>{{kRed, before}}, rows);
    const std::vector<Column> now(2, column(5, 5));
    image.draw(1, std::vector<DrawnSpan>{{kBlue, now}}, rows);
    EXPECT_EQ(lit(0, kRed), 11);
    EXPECT_EQ(lit(1, kRed), 0);
    EXPECT_EQ(lit(1, kBlue), 1);
    EXPECT_EQ(lit(3, kRed), 11);
}

TEST_F(SpanImageTest, LaterCurvesLieOnTopAndWhatIsOutsideIsCut) {
    image.resize(1, 11, 1, 1);
    const std::vector<Column> tall{column(-1e9F, 1e9F)};
    const std::vector<Column> small{column(3, 4)};
    const std::vector<Column> above{column(11, 12)};
    image.draw(0, std::vector<DrawnSpan>{{kRed, tall}, {kBlue, small}, {0xff00ff00, above}}, rows);
    EXPECT_EQ(lit(0, kBlue), 2);
    EXPECT_EQ(lit(0, kRed), 9);
    EXPECT_EQ(lit(0, 0xff00ff00), 0);
}

TEST_F(SpanImageTest, OnFineScreensLinesAreAsThickInBothDirections) {
    image.resize(3, 11, 2, 2);
    const std::vector<Column> columns(3, column(5, 5));
    image.draw(0, std::vector<DrawnSpan>{{kRed, columns}}, rows);
    for (int place = 0; place < 3; ++place)
        EXPECT_EQ(lit(place, kRed), 2) << place;
}

TEST(TimeTicks, StepsAreRoundAndNotTooMany) {
    EXPECT_EQ(tickStep(60s, 8), 10s);
    EXPECT_EQ(tickStep(60s, 6), 10s);
    EXPECT_EQ(tickStep(60s, 5), 15s);
    EXPECT_EQ(tickStep(600s, 8), 2min);
    EXPECT_EQ(tickStep(50ms, 8), 10ms);
    for (Duration span = 50ms; span < 12h; span = span * 3 / 2)
        EXPECT_LE(span / tickStep(span, 8), 8);
}

TEST(TimeTicks, CountBackFromTheRightEdge) {
    const std::vector<TimeTick> ticks = ticksBefore(TimePoint(5s), TimePoint(65s), 20s);
    ASSERT_EQ(ticks.size(), 4U);
    EXPECT_EQ(ticks[0].label, QStringLiteral("now"));
    EXPECT_EQ(ticks[0].at, TimePoint(65s));
    EXPECT_EQ(ticks[1].label, QStringLiteral("\u221220 s"));
    EXPECT_EQ(ticks[3].at, TimePoint(5s));
    EXPECT_EQ(ticksBefore(TimePoint(0s), TimePoint(1s), 200ms)[1].label, QStringLiteral("\u22120.2 s"));
    EXPECT_EQ(ticksBefore(TimePoint(0s), TimePoint(10min), 2min)[1].label, QStringLiteral("\u22122 min"));
}

TEST(TimeTicks, OfTheClockOnTheWallAreRoundByThatClock) {
    // Half a second past a full minute, whatever the time zone.
    const auto wall = std::chrono::system_clock::time_point(1'700'000'040s + 500ms);
    const std::vector<TimeTick> ticks = clockTicks(TimePoint(3s), TimePoint(63s), 10s, wall);
    ASSERT_EQ(ticks.size(), 6U);
    EXPECT_EQ(ticks[0].at, TimePoint(3s + 9500ms));
    EXPECT_TRUE(ticks[0].label.endsWith(QStringLiteral(":10"))) << ticks[0].label.toStdString();
    EXPECT_TRUE(ticks[5].label.endsWith(QStringLiteral(":00"))) << ticks[5].label.toStdString();
}

TEST(TimeTicks, LengthsOfTimeHaveUnits) {
    EXPECT_EQ(durationText(35ms), QStringLiteral("35.0 ms"));
    EXPECT_EQ(durationText(1284ms), QStringLiteral("1.284 s"));
    EXPECT_EQ(durationText(-123s), QStringLiteral("\u22122 min 3.0 s"));
}

TEST(SpreadLabels, StayWhereTheyAreWanted) {
    EXPECT_EQ(spreadLabels({20, 50}, 10, 0, 100), (std::vector<double>{20, 50}));
}

TEST(SpreadLabels, NeverOverlapNorLeaveTheirRoom) {
    const std::vector<double> places = spreadLabels({1, 2, 2, 95, 99}, 10, 0, 100);
    ASSERT_EQ(places.size(), 5U);
    EXPECT_GE(places.front(), 5);
    EXPECT_LE(places.back(), 95);
    for (std::size_t i = 1; i < places.size(); ++i)
        EXPECT_GE(places[i] - places[i - 1], 10);
}

TEST(SpreadLabels, ThoseThatDoNotFitAreLeftOut) {
    EXPECT_EQ(spreadLabels({1, 2, 3, 4, 5}, 10, 0, 35).size(), 3U);
    EXPECT_TRUE(spreadLabels({1}, 10, 0, 5).empty());
}

TEST(CurveColours, TheFirstSevenRobotsShareNone) {
    for (int first = 0; first < 16; ++first) {
        std::vector<std::uint16_t> units;
        for (int i = 0; i < 7; ++i)
            units.push_back(static_cast<std::uint16_t>((first + 3 * i) % 16));
        const std::vector<int> colours = colourIndices(units);
        EXPECT_EQ(QSet<int>(colours.begin(), colours.end()).size(), 7) << first;
    }
}

TEST(CurveColours, ARobotAloneKeepsItsColour) {
    EXPECT_EQ(colourIndices({3}), (std::vector<int>{3}));
    EXPECT_EQ(colourIndices({2, 3, 5}), (std::vector<int>{2, 3, 5}));
}

TEST(CurveColours, CanBeSeenOnTheirGround) {
    for (int i = 0; i < kCurveColours; ++i) {
        EXPECT_LT(curveColour(i, false).lightnessF(), 0.75F) << i;
        EXPECT_GT(curveColour(i, true).lightnessF(), 0.25F) << i;
    }
}

class TriggerTest : public testing::Test {
  protected:
    void add(int at_s, float value) { series.append(TimePoint(std::chrono::seconds(at_s)), value); }

    TimeSeries series{64};
};

TEST_F(TriggerTest, FindsTheFirstCrossingInItsDirection) {
    add(1, 0);
    Trigger rising(series, Edge::Rising, 10);
    Trigger falling(series, Edge::Falling, 10);
    add(2, 20);
    add(3, 5);
    add(4, 20);
    EXPECT_EQ(rising.check(), TimePoint(2s));
    EXPECT_EQ(falling.check(), TimePoint(3s));
}

TEST_F(TriggerTest, ReachingTheLevelCounts) {
    add(1, 0);
    Trigger trigger(series, Edge::Rising, 10);
    add(2, 10);
    EXPECT_EQ(trigger.check(), TimePoint(2s));
    EXPECT_EQ(trigger.check(), std::nullopt);
}

TEST_F(TriggerTest, WhatWasBeforeItWasArmedDoesNotCount) {
    add(1, 0);
    add(2, 20);
    Trigger trigger(series, Edge::Rising, 10);
    EXPECT_EQ(trigger.check(), std::nullopt);
    add(3, 0);
    EXPECT_EQ(trigger.check(), std::nullopt);
    add(4, 30);
    EXPECT_EQ(trigger.check(), TimePoint(4s));
}

TEST_F(TriggerTest, ComingOutOfAGapIsNoCrossing) {
    add(1, 0);
    Trigger trigger(series, Edge::Rising, 10);
    series.gap(TimePoint(2s));
    add(3, 20);
    EXPECT_EQ(trigger.check(), std::nullopt);
}

TEST_F(TriggerTest, WhatWasOverwrittenUnseenIsTakenForAGap) {
    add(1, 0);
    Trigger trigger(series, Edge::Rising, 10);
    for (int i = 0; i < 500; ++i)
        add(2 + i, 20.0F + static_cast<float>(i));
    EXPECT_EQ(trigger.check(), std::nullopt);
    add(1000, 5);
    add(1001, 15);
    EXPECT_EQ(trigger.check(), TimePoint(1001s));
}

TEST_F(TriggerTest, AnEmptySeriesIsWaitedFor) {
    Trigger trigger(series, Edge::Falling, 10);
    EXPECT_EQ(trigger.check(), std::nullopt);
    add(1, 20);
    EXPECT_EQ(trigger.check(), std::nullopt);
    add(2, 1);
    EXPECT_EQ(trigger.check(), TimePoint(2s));
}

TEST(SeenCsv, HasALineAColumnAndEmptyCellsInGaps) {
    Seen seen{TimePoint(5s), 500ms, {}};
    seen.curves.push_back({QStringLiteral("3 battery [V]"), {{15.5F, 15.75F, 15.5F, 15.75F, 2}, Column{}}});
    seen.curves.push_back({QStringLiteral("a,\"b\""), {{-1, 2, 0, 0, 1}, {0, 0, 0, 0, 0}}});
    const QString text =
        csvOf(seen, [](TimePoint time) { return QString::number(seconds(time.time_since_epoch())); });
    EXPECT_EQ(text.toStdString(),
              "time_s,clock,3 battery [V] min,3 battery [V] max,\"a,\"\"b\"\" min\",\"a,\"\"b\"\" max\"\n"
              "0.000000,5,15.5,15.75,-1,2\n"
              "0.500000,5.5,,,0,0\n");
}

}  // namespace
}  // namespace kickstand::ui
