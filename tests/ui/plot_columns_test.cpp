// Which columns are seen, which are drawn, and which lie where.

#include <chrono>
#include <set>

#include <gtest/gtest.h>

#include "ui/plot/column_ring.h"
#include "ui/plot/cursors.h"
#include "ui/plot/time_view.h"

namespace kickstand::ui {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kFuture = 1'000'000;

/// All columns that a call of show() asks to draw.
std::set<std::int64_t> drawnBy(ColumnRing& ring, ColumnSpan wanted, std::int64_t settled = kFuture,
                               std::int64_t present = kFuture) {
    std::set<std::int64_t> columns;
    for (const ColumnSpan& span : ring.show(wanted, settled, present)) {
        for (std::int64_t column = span.first; column < span.end; ++column)
            EXPECT_TRUE(columns.insert(column).second) << "drawn twice: " << column;
    }
    return columns;
}

std::set<std::int64_t> range(std::int64_t first, std::int64_t end) {
    std::set<std::int64_t> columns;
    for (; first < end; ++first)
        columns.insert(first);
    return columns;
}

TEST(Columns, AreCountedFromTheClocksZeroAlsoBelowIt) {
    EXPECT_EQ(columnAt(TimePoint(0ns), 10ns), 0);
    EXPECT_EQ(columnAt(TimePoint(9ns), 10ns), 0);
    EXPECT_EQ(columnAt(TimePoint(10ns), 10ns), 1);
    EXPECT_EQ(columnAt(TimePoint(-1ns), 10ns), -1);
    EXPECT_EQ(columnAt(TimePoint(-10ns), 10ns), -1);
    EXPECT_EQ(columnAt(TimePoint(-11ns), 10ns), -2);
    EXPECT_EQ(startOf(-2, 10ns), TimePoint(-20ns));
}

TEST(ColumnRing, DrawsEverythingOnceAndThenOnlyWhatIsNew) {
    ColumnRing ring;
    ring.reset(100);
    EXPECT_EQ(drawnBy(ring, {0, 100}), range(0, 100));
    EXPECT_TRUE(drawnBy(ring, {0, 100}).empty());
    EXPECT_EQ(drawnBy(ring, {3, 103}), range(100, 103));
    EXPECT_EQ(drawnBy(ring, {-4, 96}), range(-4, 3));
}

TEST(ColumnRing, DrawsAllAgainAfterAJumpOrAReset) {
    ColumnRing ring;
    ring.reset(100);
    drawnBy(ring, {0, 100});
    EXPECT_EQ(drawnBy(ring, {500, 600}), range(500, 600));
    ring.reset(100);
    EXPECT_EQ(drawnBy(ring, {500, 600}), range(500, 600));
}

TEST(ColumnRing, DrawsAgainWhatMayStillChangeAndNothingOfTheFuture) {
    ColumnRing ring;
    ring.reset(100);
    EXPECT_EQ(drawnBy(ring, {0, 100}, 48, 51), range(0, 51));
    EXPECT_EQ(drawnBy(ring, {0, 100}, 49, 52), range(48, 52));
    EXPECT_EQ(drawnBy(ring, {0, 100}, 60, 63), range(49, 63));
}

TEST(ColumnRing, AViewWhollyInTheFutureShowsNothing) {
    ColumnRing ring;
    ring.reset(10);
    EXPECT_TRUE(drawnBy(ring, {100, 110}, 5, 6).empty());
    EXPECT_EQ(drawnBy(ring, {100, 110}, 102, 104), range(100, 104));
}

TEST(ColumnRing, PiecesCoverASpanOnceAndLieInsideTheRing) {
    ColumnRing ring;
    ring.reset(7);
    for (std::int64_t first = -20; first < 20; ++first) {
        for (std::int64_t count = 0; count <= 7; ++count) {
            std::int64_t next = first;
            std::set<int> places;
            for (const ColumnRing::Piece& piece : ring.piecesOf({first, first + count})) {
                for (int i = 0; i < piece.count; ++i) {
                    EXPECT_EQ(ring.placeOf(piece.first + i), piece.place + i);
                    EXPECT_EQ(piece.first + i, next++);
                    EXPECT_TRUE(places.insert(piece.place + i).second);
                    EXPECT_GE(piece.place, 0);
                    EXPECT_LT(piece.place + i, 7);
                }
            }
            EXPECT_EQ(next, first + count);
        }
    }
}

class TimeViewTest : public testing::Test {
  protected:
    TimeViewTest() {
        view.setColumns(600);
        view.setSpan(60s);
        view.advance(TimePoint(1h));
    }

    TimeView view;
};

TEST_F(TimeViewTest, FollowsThePresentByWholeColumns) {
    EXPECT_EQ(view.columnWidth(), 100ms);
    EXPECT_EQ(view.end(), TimePoint(1h + 100ms));
    view.advance(TimePoint(1h + 99ms));
    EXPECT_EQ(view.end(), TimePoint(1h + 100ms));
    view.advance(TimePoint(1h + 100ms));
    EXPECT_EQ(view.end(), TimePoint(1h + 200ms));
    EXPECT_EQ(view.begin(), view.end() - 60s);
}

TEST_F(TimeViewTest, PausedItStaysUntilItFollowsAgain) {
    view.pause();
    const ColumnSpan before = view.shown();
    view.advance(TimePoint(2h));
    EXPECT_EQ(view.shown(), before);
    view.follow();
    EXPECT_EQ(view.end(), TimePoint(2h + 100ms));
}

TEST_F(TimeViewTest, PanningStopsFollowingAndGoesHalfIntoTheFutureAtMost) {
    view.pan(-50);
    EXPECT_FALSE(view.isFollowing());
    EXPECT_EQ(view.end(), TimePoint(1h + 100ms - 5s));
    view.pan(100'000);
    EXPECT_EQ(view.end(), TimePoint(1h + 100ms + 30s));
}

TEST_F(TimeViewTest, ZoomingKeepsWhatIsUnderThePointer) {
    view.pause();
    for (const double place : {0.0, 0.25, 0.5, 0.9}) {
        const TimePoint before = view.timeAt(place);
        view.zoom(0.5, place);
        EXPECT_LE(std::chrono::abs(view.timeAt(place) - before), view.columnWidth()) << place;
        view.zoom(2, place);
    }
    EXPECT_EQ(view.span(), 60s);
}

TEST_F(TimeViewTest, ZoomingWhileFollowingKeepsThePresentAtTheEdge) {
    view.zoom(0.1, 0.2);
    EXPECT_TRUE(view.isFollowing());
    EXPECT_EQ(view.span(), 6s);
    EXPECT_EQ(columnAt(view.now(), view.columnWidth()) + 1, view.shown().end);
}

TEST_F(TimeViewTest, SpansHaveLimits) {
    view.zoom(1e-9, 0.5);
    EXPECT_EQ(view.span(), TimeView::kShortest);
    view.zoom(1e9, 0.5);
    EXPECT_EQ(view.span(), TimeView::kLongest);
    EXPECT_GE(view.columnWidth(), 1ns);
}

TEST_F(TimeViewTest, AMomentIsPutIntoTheMiddleColumn) {
    const TimePoint moment(30min + 7ms);
    view.centre(moment);
    EXPECT_EQ(view.middle(), columnAt(moment, view.columnWidth()));
    EXPECT_NEAR(view.placeOf(moment), 0.5, 2.0 / view.columns());
    EXPECT_FALSE(view.isFollowing());
}

TEST_F(TimeViewTest, AnotherWidthKeepsSpanAndMiddle) {
    view.pause();
    const TimePoint middle = view.timeAt(0.5);
    view.setColumns(1000);
    EXPECT_EQ(view.span(), 60s);
    EXPECT_LE(std::chrono::abs(view.timeAt(0.5) - middle), 2 * view.columnWidth());
}

TEST_F(TimeViewTest, TheClockNeverGoesBack) {
    view.advance(TimePoint(30min));
    EXPECT_EQ(view.now(), TimePoint(1h));
}

TEST_F(TimeViewTest, CursorsBeginInTheViewAndStayInIt) {
    Cursors cursors;
    EXPECT_EQ(cursors.nearest(view.begin(), 1h), -1);
    cursors.show(view);
    EXPECT_NEAR(view.placeOf(cursors.at(0)), 1.0 / 3, 1e-6);
    EXPECT_NEAR(view.placeOf(cursors.at(1)), 2.0 / 3, 1e-6);
    EXPECT_NEAR(seconds(cursors.delta()), 20, 1e-3);
    cursors.step(-3, view);
    EXPECT_NEAR(seconds(cursors.delta()), 20.3, 1e-3);
    cursors.step(-10'000, view);
    EXPECT_EQ(cursors.at(0), view.begin());
    cursors.activate(1);
    cursors.step(10'000, view);
    EXPECT_EQ(cursors.at(1), view.end());
}

TEST_F(TimeViewTest, TheNearestCursorIsTaken) {
    Cursors cursors;
    cursors.show(view);
    cursors.put(0, TimePoint(10s));
    cursors.put(1, TimePoint(11s));
    EXPECT_EQ(cursors.nearest(TimePoint(10400ms), 1s), 0);
    EXPECT_EQ(cursors.nearest(TimePoint(10600ms), 1s), 1);
    EXPECT_EQ(cursors.nearest(TimePoint(13s), 1s), -1);
    EXPECT_EQ(cursors.nearest(TimePoint(10500ms), 1s), cursors.active());
    cursors.put(1, TimePoint(9s));
    EXPECT_EQ(cursors.delta(), -1s);
}

}  // namespace
}  // namespace kickstand::ui
