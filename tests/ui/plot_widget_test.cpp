// The plot as a person uses it, on a store that is written meanwhile.

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <chrono>
#include <cstdlib>

#include <gtest/gtest.h>

#include "ui/plot/curve_colours.h"
#include "ui/plot/plot_scene.h"
#include "ui/plot/plot_text.h"
#include "ui/plot/time_plot.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {
namespace {

using namespace std::chrono_literals;

constexpr SignalId kSignal{3, 0};
constexpr SignalId kOther{5, 1};

class PlotWidgetTest : public testing::Test {
  protected:
    PlotWidgetTest() {
        plot.setPalette(paletteOf(lightTokens()));
        plot.resize(800, 300);
        plot.setStore(store);
        plot.setContents({{QStringLiteral("First, V"), QStringLiteral("V"), 1, {0, 10}, {}},
                          {QStringLiteral("Second, V"), QStringLiteral("V"), 0, {0, 200}, {}}},
                         {{kSignal, 0, QStringLiteral("3 first"), QStringLiteral("3"), 0},
                          {kOther, 1, QStringLiteral("5 second"), QStringLiteral("5"), 1}});
        plot.setDescribeMark([](const Mark& mark) -> std::optional<MarkWords> {
            if (mark.kind == MarkKind::Rearmed) return std::nullopt;
            return MarkWords{QStringLiteral("mark"), QStringLiteral("a mark"), {}};
        });
        plot.setSpan(60s);
        plot.show();
        plot.canvas().setFocus();
        QApplication::setActiveWindow(&plot);
        goTo(100s);
    }

    /// The present is this; what changed is drawn.
    void goTo(Duration time) {
        now = TimePoint(time);
        plot.frame();
        QApplication::processEvents();
    }
    /// Draws all columns again: what a test writes into the past has been drawn without it.
    void drawAll() {
        plot.setStore(nullptr);
        plot.setStore(store);
        goTo(now.time_since_epoch());
    }
    void add(SignalId signal, Duration time, float value) { store->append(signal, TimePoint(time), value); }
    const TimeView& view() const { return plot.state().view; }
    const ShownArea& area(std::size_t index) const { return plot.state().areas[index]; }

    QPoint placeOf(Duration time, std::size_t inArea = 0) {
        const PlotGeometry geometry = plot.scene().geometry();
        return {static_cast<int>(geometry.xOf(view(), TimePoint(time))), geometry.areas[inArea].center().y()};
    }
    /// Whether the first curve's colour is anywhere in the column of a moment.
    bool isDrawnAt(Duration time) {
        const QImage image = plot.picture().toImage();
        const int x = placeOf(time).x();
        const QRect rect = plot.scene().geometry().areas[0];
        for (int y = rect.top(); y <= rect.bottom(); ++y) {
            if (image.pixelColor(x, y) == curveColour(0, false)) return true;
        }
        return false;
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&plot.canvas(), key, modifiers);
    }
    void turnWheel(QPoint at, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWheelEvent event(at, plot.canvas().mapToGlobal(at), {}, QPoint(0, notches * 120), Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot.canvas(), &event);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(&plot.canvas(), Qt::LeftButton, modifiers, from);
        QMouseEvent move(QEvent::MouseMove, to, plot.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QApplication::sendEvent(&plot.canvas(), &move);
        QTest::mouseRelease(&plot.canvas(), Qt::LeftButton, modifiers, to);
    }

    TimePoint now{};
    std::shared_ptr<TelemetryStore> store = std::make_shared<TelemetryStore>();
    TimePlot plot{
        {[this] { return now; },
         [](TimePoint time) {
             return std::chrono::system_clock::time_point(
                 std::chrono::duration_cast<std::chrono::system_clock::duration>(time.time_since_epoch()));
         }}};
};

TEST_F(PlotWidgetTest, HoldsTheLastValueAndHasGapsOnlyWhereTheStoreHasThem) {
    add(kSignal, 50s, 5);
    store->gap(3, TimePoint(70s));
    add(kSignal, 80s, 5);
    drawAll();
    EXPECT_FALSE(isDrawnAt(48s));
    EXPECT_TRUE(isDrawnAt(52s));
    EXPECT_TRUE(isDrawnAt(68s));
    EXPECT_FALSE(isDrawnAt(72s));
    EXPECT_FALSE(isDrawnAt(78s));
    EXPECT_TRUE(isDrawnAt(82s));
    EXPECT_TRUE(isDrawnAt(99s));
}

TEST_F(PlotWidgetTest, FollowingDrawsOnlyNewColumns) {
    add(kSignal, 50s, 5);
    goTo(101s);
    const std::uint64_t before = plot.scene().drawnColumns();
    add(kSignal, 101s, 6);
    goTo(101s + 200ms);
    // Those that passed and those that were not settled, in two areas.
    EXPECT_GT(plot.scene().drawnColumns(), before);
    EXPECT_LE(plot.scene().drawnColumns() - before, 20U);
}

TEST_F(PlotWidgetTest, WithoutAnythingNewNothingIsDrawn) {
    add(kSignal, 50s, 5);
    goTo(101s);
    const std::uint64_t before = plot.scene().drawnColumns();
    plot.frame();
    plot.frame();
    EXPECT_EQ(plot.scene().drawnColumns(), before);
}

TEST_F(PlotWidgetTest, PausingChangesTheViewAndNotTheData) {
    add(kSignal, 50s, 5);
    press(Qt::Key_P);
    const ColumnSpan shown = view().shown();
    add(kSignal, 101s, 6);
    goTo(130s);
    EXPECT_EQ(view().shown(), shown);
    EXPECT_FALSE(plot.isFollowing());
    press(Qt::Key_F);
    EXPECT_TRUE(plot.isFollowing());
    EXPECT_EQ(plot.valueAt(plot.state().curves[0], TimePoint(129s)), 6);
}

TEST_F(PlotWidgetTest, WhatComesAfterAPausedViewBeganIsDrawnIntoIt) {
    add(kSignal, 50s, 5);
    plot.panTime(view().columns() / 2);
    goTo(105s);
    EXPECT_TRUE(isDrawnAt(104s));
    EXPECT_FALSE(isDrawnAt(120s));
    goTo(125s);
    EXPECT_TRUE(isDrawnAt(120s));
}

TEST_F(PlotWidgetTest, DraggingPansAndADoubleClickFollowsAgain) {
    drag({400, 80}, {500, 80});
    EXPECT_FALSE(plot.isFollowing());
    EXPECT_NEAR(seconds(now - view().end()), 60.0 * 100 / view().columns(), 0.3);
    QTest::mouseDClick(&plot.canvas(), Qt::LeftButton, {}, {400, 80});
    EXPECT_TRUE(plot.isFollowing());
}

TEST_F(PlotWidgetTest, DraggingWithCtrlMovesTheValuesOfThatAreaAlone) {
    const ValueRange before = area(1).range;
    const QPoint at = placeOf(80s, 1);
    drag(at, at + QPoint(0, 20), Qt::ControlModifier);
    EXPECT_GT(area(1).range.high, before.high);
    EXPECT_EQ(area(0).range, (ValueRange{0, 10}));
    EXPECT_TRUE(plot.isFollowing());
}

TEST_F(PlotWidgetTest, TheWheelZoomsTimeAndWithCtrlValues) {
    turnWheel(placeOf(80s), 2);
    EXPECT_LT(view().span(), 40s);
    EXPECT_TRUE(plot.isFollowing());
    turnWheel(placeOf(80s), -2);
    EXPECT_NEAR(seconds(view().span()), 60, 0.1);
    plot.pause();
    const Duration before = view().timeAt(0.25) - TimePoint();
    turnWheel(placeOf(before), 1);
    EXPECT_NEAR(view().placeOf(TimePoint(before)), 0.25, 0.01);
    turnWheel(placeOf(80s, 1), 1, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(area(0).range.size(), 10);
    EXPECT_LT(area(1).range.size(), 200);
}

TEST_F(PlotWidgetTest, EverythingHasAKey) {
    press(Qt::Key_Plus);
    EXPECT_EQ(view().span(), 48s);
    press(Qt::Key_Minus);
    EXPECT_EQ(view().span(), 60s);
    press(Qt::Key_Left);
    EXPECT_FALSE(plot.isFollowing());
    const TimePoint end = view().end();
    press(Qt::Key_Right);
    EXPECT_GT(view().end(), end);
    press(Qt::Key_End);
    EXPECT_TRUE(plot.isFollowing());
    press(Qt::Key_PageDown);
    EXPECT_EQ(plot.state().keyArea, 1);
    press(Qt::Key_Up);
    EXPECT_GT(area(1).range.low, 0);
    press(Qt::Key_Plus, Qt::ControlModifier);
    EXPECT_LT(area(1).range.size(), 200);
    press(Qt::Key_U);
    EXPECT_EQ(area(1).range, (ValueRange{0, 200}));
    press(Qt::Key_PageUp);
    EXPECT_EQ(plot.state().keyArea, 0);
}

TEST_F(PlotWidgetTest, TheOldestIsShownFromTheLeftEdge) {
    add(kSignal, 12s, 5);
    press(Qt::Key_Home);
    EXPECT_EQ(columnAt(TimePoint(12s), view().columnWidth()), view().shown().first);
}

TEST_F(PlotWidgetTest, ValuesAreFittedAndGoBackToTheirUsualRange) {
    add(kSignal, 90s, 5);
    add(kSignal, 95s, 6);
    press(Qt::Key_V);
    EXPECT_GT(area(0).range.low, 4.5);
    EXPECT_LT(area(0).range.high, 6.5);
    press(Qt::Key_U);
    EXPECT_EQ(area(0).range, (ValueRange{0, 10}));
}

TEST_F(PlotWidgetTest, TheUsualRangeWidensForWhatLiesOutside) {
    add(kSignal, 90s, 12);
    press(Qt::Key_U);
    EXPECT_EQ(area(0).range, (ValueRange{0, 12}));
}

TEST_F(PlotWidgetTest, CursorsAreShownDraggedAndMovedByKeys) {
    press(Qt::Key_C);
    ASSERT_TRUE(plot.state().cursors.isShown());
    const Duration first = plot.state().cursors.at(0) - TimePoint();
    drag(placeOf(first), placeOf(first) + QPoint(50, 0));
    EXPECT_GT(plot.state().cursors.at(0), TimePoint(first));
    EXPECT_TRUE(plot.isFollowing());
    const TimePoint before = plot.state().cursors.at(0);
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(plot.state().cursors.at(0) - before, view().columnWidth());
    press(Qt::Key_X);
    press(Qt::Key_Left, Qt::ShiftModifier | Qt::ControlModifier);
    EXPECT_EQ(plot.state().cursors.active(), 1);
    press(Qt::Key_C);
    EXPECT_FALSE(plot.state().cursors.isShown());
}

TEST_F(PlotWidgetTest, ATriggerStandsStillWithTheCrossingInTheMiddle) {
    QSignalSpy triggered(&plot, &TimePlot::triggered);
    add(kSignal, 90s, 2);
    plot.arm(kSignal, Edge::Rising, 5);
    goTo(101s);
    EXPECT_EQ(triggered.count(), 0);
    add(kSignal, 102s, 8);
    goTo(103s);
    EXPECT_EQ(triggered.count(), 1);
    EXPECT_FALSE(plot.isFollowing());
    EXPECT_EQ(view().middle(), columnAt(TimePoint(102s), view().columnWidth()));
    ASSERT_TRUE(plot.state().trigger);
    EXPECT_EQ(plot.state().trigger->state, PlotTrigger::State::Caught);
    // Data go on arriving, and are drawn.
    goTo(120s);
    EXPECT_TRUE(isDrawnAt(115s));
    add(kSignal, 121s, 2);
    add(kSignal, 122s, 8);
    goTo(123s);
    EXPECT_EQ(triggered.count(), 1);
}

TEST_F(PlotWidgetTest, ATriggerWaitsForACurveThatIsNotThereYetAndEndsWithIt) {
    plot.arm(kSignal, Edge::Falling, 5);
    goTo(101s);
    add(kSignal, 102s, 8);
    goTo(102s + 500ms);
    add(kSignal, 103s, 1);
    goTo(104s);
    EXPECT_EQ(plot.state().trigger->state, PlotTrigger::State::Caught);
    plot.setContents({}, {});
    EXPECT_FALSE(plot.state().trigger);
}

TEST_F(PlotWidgetTest, MarksAreWalkedByKeyAndThoseThatAreNotDescribedAreSkipped) {
    store->mark({TimePoint(20s), MarkKind::Kick, 3, 0});
    store->mark({TimePoint(30s), MarkKind::Rearmed, kNoUnit, 0});
    store->mark({TimePoint(40s), MarkKind::Stop, kNoUnit, 0});
    press(Qt::Key_M, Qt::ShiftModifier);
    EXPECT_EQ(view().middle(), columnAt(TimePoint(40s), view().columnWidth()));
    EXPECT_TRUE(plot.canvas().accessibleDescription().contains(QStringLiteral("a mark")));
    press(Qt::Key_M, Qt::ShiftModifier);
    EXPECT_EQ(view().middle(), columnAt(TimePoint(20s), view().columnWidth()));
    press(Qt::Key_M);
    EXPECT_EQ(view().middle(), columnAt(TimePoint(40s), view().columnWidth()));
    EXPECT_FALSE(plot.goToMark(true));
}

TEST_F(PlotWidgetTest, AMarkIsFoundNearThePointerOnly) {
    store->mark({TimePoint(80s), MarkKind::Kick, 3, 0});
    goTo(101s);
    const PlotGeometry geometry = plot.scene().geometry();
    const double x = geometry.xOf(view(), TimePoint(80s));
    ASSERT_TRUE(markNear(plot.state(), geometry, x + 3));
    EXPECT_EQ(markNear(plot.state(), geometry, x + 3)->kind, MarkKind::Kick);
    EXPECT_FALSE(markNear(plot.state(), geometry, x + 12));
}

TEST_F(PlotWidgetTest, StatisticsAreOfTheVisibleSpan) {
    add(kSignal, 10s, 9);
    add(kSignal, 60s, 2);
    add(kSignal, 90s, 4);
    goTo(100s);
    const auto stats = plot.statsOf(plot.state().curves[0]);
    ASSERT_TRUE(stats);
    EXPECT_EQ(stats->max, 9);
    plot.setSpan(30s);
    EXPECT_EQ(plot.statsOf(plot.state().curves[0])->max, 4);
    EXPECT_NEAR(plot.statsOf(plot.state().curves[0])->mean, 2.67, 0.05);
    EXPECT_FALSE(plot.statsOf(plot.state().curves[1]));
}

TEST_F(PlotWidgetTest, WhatIsSeenEndsAtThePresent) {
    add(kSignal, 50s, 5);
    plot.panTime(view().columns() / 2);
    const Seen seen = plot.seen();
    ASSERT_EQ(seen.curves.size(), 2U);
    EXPECT_NEAR(static_cast<double>(seen.curves[0].columns.size()), view().columns() / 2.0, 2);
    EXPECT_EQ(seen.curves[0].columns.back().max, 5);
    EXPECT_TRUE(std::isnan(seen.curves[1].columns.back().max));
}

TEST_F(PlotWidgetTest, AnotherThemeRedrawsTheCurves) {
    add(kSignal, 50s, 5);
    drawAll();
    EXPECT_TRUE(isDrawnAt(80s));
    plot.setPalette(paletteOf(darkTokens()));
    QApplication::processEvents();
    const QImage image = plot.picture().toImage();
    EXPECT_EQ(image.pixelColor(2, 2), darkTokens().surface);
    EXPECT_FALSE(isDrawnAt(80s));
}

TEST_F(PlotWidgetTest, WithNothingToShowKeysDoNothing) {
    plot.setStore(nullptr);
    plot.setContents({}, {});
    for (const Qt::Key key : {Qt::Key_Up, Qt::Key_V, Qt::Key_M, Qt::Key_Left, Qt::Key_C, Qt::Key_Home})
        press(key);
    turnWheel({300, 100}, 1);
    drag({300, 100}, {350, 100});
    goTo(102s);
    EXPECT_TRUE(plot.seen().curves.empty());
}

/// A gap in a curve means that nothing was heard: nothing else may look like one.
TEST_F(PlotWidgetTest, ACurveGoesOnBehindTheNameOfItsThreshold) {
    const QString name = QStringLiteral("5.0 V, locks itself out");
    plot.setContents({{QStringLiteral("V"), QStringLiteral("V"), 1, {0, 10}, {{5, name}}}},
                     {{kSignal, 0, QStringLiteral("3 first"), QStringLiteral("3"), 0}});
    const QImage without = plot.picture().toImage();
    const QRect rect = plot.scene().geometry().areas[0];
    constexpr int kAboveLine = 6;
    const double step = 10.0 / rect.height();
    for (Duration time = 30s; time < 100s; time += 100ms)
        add(kSignal, time, static_cast<float>(5 + kAboveLine * step));
    drawAll();
    const QImage with = plot.picture().toImage();
    const auto shows = [&](int x) {
        for (int y = rect.center().y() - 2 * kAboveLine; y < rect.center().y(); ++y) {
            const QColor before = without.pixelColor(x, y);
            const QColor after = with.pixelColor(x, y);
            if (std::abs(before.red() - after.red()) + std::abs(before.green() - after.green()) > 40)
                return true;
        }
        return false;
    };
    constexpr int kNameLeft = 8;
    const int end = rect.left() + kNameLeft + textWidth(plotFonts().text, name, 0);
    int hidden = 0;
    int longest = 0;
    for (int x = rect.left(); x < end; ++x) {
        hidden = shows(x) ? 0 : hidden + 1;
        longest = std::max(longest, hidden);
    }
    EXPECT_LE(longest, 2) << "pixels in a row, of " << end - rect.left();
}

}  // namespace
}  // namespace kickstand::ui
