// What marks look like in the plot: told apart by shape, in words above the curves.

#include <QApplication>
#include <chrono>
#include <set>

#include <gtest/gtest.h>

#include "ui/plot/described_marks.h"
#include "ui/plot/mark_looks.h"
#include "ui/plot/plot_scene.h"
#include "ui/plot/time_plot.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {
namespace {

using namespace std::chrono_literals;

constexpr int kKinds = static_cast<int>(MarkKind::UnitLost) + 1;

std::vector<bool> inkOf(const QPixmap& pixmap) {
    const QImage image = pixmap.toImage();
    std::vector<bool> ink;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            ink.push_back(qAlpha(image.pixel(x, y)) > 127);
    }
    return ink;
}

TEST(MarkLooks, EveryKindHasAShapeAndALineOfItsOwn) {
    std::set<std::vector<bool>> shapes;
    std::set<std::vector<bool>> lines;
    for (int kind = kTriggerLook; kind < kKinds; ++kind) {
        shapes.insert(inkOf(markGlyph(kind, Qt::black, 1)));
        lines.insert(inkOf(markLine(kind, Qt::black, 100, 1)));
    }
    EXPECT_EQ(shapes.size(), kLooks);
    EXPECT_EQ(lines.size(), kLooks);
}

class DescribedMarksTest : public testing::Test {
  protected:
    DescribedMarksTest() {
        state.store = store;
        state.describeMark = [this](const Mark& mark) -> std::optional<MarkWords> {
            ++asked;
            if (mark.unit == 9) return std::nullopt;
            return MarkWords{QStringLiteral("unit %1").arg(mark.unit), {}, {}};
        };
        marks.forget(QFont());
    }
    void add(Duration time, std::uint16_t unit) {
        store->mark({TimePoint(time), MarkKind::UnitHeard, unit, 0});
    }
    std::size_t seen(Duration from, Duration to) {
        marks.update(state);
        return marks.between(TimePoint(from), TimePoint(to)).size();
    }

    std::shared_ptr<TelemetryStore> store = std::make_shared<TelemetryStore>(TelemetryLimits{.marks = 100});
    PlotState state;
    DescribedMarks marks;
    int asked = 0;
};

TEST_F(DescribedMarksTest, EachMarkIsAskedForOnce) {
    for (std::uint16_t unit = 0; unit < 10; ++unit)
        add(1s * unit, unit);
    EXPECT_EQ(seen(0s, 100s), 9U);
    EXPECT_EQ(seen(2s, 5s), 3U);
    EXPECT_EQ(asked, 10);
    add(20s, 3);
    EXPECT_EQ(seen(0s, 100s), 10U);
    EXPECT_EQ(asked, 11);
}

TEST_F(DescribedMarksTest, AnotherStoreAndOtherWordsAreAskedForAnew) {
    add(1s, 1);
    EXPECT_EQ(seen(0s, 10s), 1U);
    state.store = std::make_shared<TelemetryStore>();
    EXPECT_EQ(seen(0s, 10s), 0U);
    state.store = store;
    EXPECT_EQ(seen(0s, 10s), 1U);
    marks.forget(QFont());
    EXPECT_EQ(seen(0s, 10s), 1U);
    EXPECT_EQ(asked, 3);
}

TEST_F(DescribedMarksTest, HoldsNoMoreThanTheStoreDoes) {
    for (int i = 0; i < 1000; ++i) {
        add(1ms * i, 1);
        if (i % 150 == 0) marks.update(state);
    }
    EXPECT_LE(seen(0s, 10s), store->marks().capacity());
    EXPECT_GT(seen(0s, 10s), 0U);
}

TEST_F(DescribedMarksTest, SeveralAreToldTogetherByTheirCount) {
    add(1s, 5);
    marks.update(state);
    const DescribedMarks::Item& first = *marks.between(TimePoint(0s), TimePoint(2s)).front();
    EXPECT_EQ(marks.together(state, first, {0, 3, 1U << 5}).text, QStringLiteral("unit 5 \u00d73"));
    marks.forget(QFont());
    marks.update(state);
    std::vector<MarkCount> counts;
    state.countMarks = [&counts](const MarkCount& count) {
        counts.push_back(count);
        return QStringLiteral("many");
    };
    const DescribedMarks::Item& again = *marks.between(TimePoint(0s), TimePoint(2s)).front();
    EXPECT_EQ(marks.together(state, again, {0, 16, 0xFFFF}).text, QStringLiteral("many"));
    EXPECT_EQ(marks.together(state, again, {0, 16, 0xFFFF}).text, QStringLiteral("many"));
    EXPECT_EQ(counts, (std::vector<MarkCount>{{MarkKind::UnitHeard, 16, 16, 5}}));
}

class PlotMarksTest : public testing::Test {
  protected:
    PlotMarksTest() {
        plot.setPalette(paletteOf(lightTokens()));
        plot.resize(800, 300);
        plot.setStore(store);
        plot.setContents({{QStringLiteral("First, V"), QStringLiteral("V"), 1, {0, 10}, {}},
                          {QStringLiteral("Second, V"), QStringLiteral("V"), 0, {0, 200}, {}}},
                         {});
        plot.setDescribeMark([](const Mark&) {
            return std::optional(MarkWords{QStringLiteral("mark"), {}, {}});
        });
        plot.setSpan(60s);
        plot.show();
        QApplication::processEvents();
    }
    PlotGeometry geometry() { return plot.scene().geometry(); }
    QRect laneRow(int row) {
        const PlotGeometry at = geometry();
        return {at.areas[0].left(), static_cast<int>(at.laneRowTop(row)), at.areas[0].width(),
                kLaneRowHeight};
    }
    /// Whether anything but the ground is drawn there.
    bool isInked(const QRect& rect) {
        const QImage image = plot.picture().toImage();
        for (int y = rect.top(); y <= rect.bottom(); ++y) {
            for (int x = rect.left(); x <= rect.right(); ++x) {
                if (image.pixelColor(x, y) != lightTokens().surface) return true;
            }
        }
        return false;
    }

    TimePoint now{100s};
    std::shared_ptr<TelemetryStore> store = std::make_shared<TelemetryStore>();
    TimePlot plot{
        {[this] { return now; }, [](TimePoint) { return std::chrono::system_clock::time_point(); }}};
};

TEST_F(PlotMarksTest, WordsStandAboveTheAreas) {
    const int top = geometry().laneRows - 1;
    EXPECT_FALSE(isInked(laneRow(top)));
    store->mark({TimePoint(70s), MarkKind::Kick, 3, 2400});
    now = TimePoint(101s);
    EXPECT_TRUE(isInked(laneRow(top)));
    EXPECT_LT(laneRow(0).bottom(), geometry().areas[0].top());
}

TEST_F(PlotMarksTest, TheTimeBetweenTheCursorsHasARowOfItsOwn) {
    plot.showCursors(true);
    const int top = geometry().laneRows - 1;
    EXPECT_TRUE(isInked(laneRow(top)));
    EXPECT_FALSE(isInked(laneRow(0)));
}

TEST_F(PlotMarksTest, AreasAreEquallyHighUnderTheLane) {
    const PlotGeometry at = geometry();
    EXPECT_NEAR(at.areas[0].height(), at.areas[1].height(), 1);
    EXPECT_GE(at.areas[0].top(), laneHeight(at.laneRows));
    plot.resize(800, 140);
    QApplication::processEvents();
    plot.picture();
    EXPECT_LT(geometry().laneRows, at.laneRows);
    EXPECT_NEAR(geometry().areas[0].height(), geometry().areas[1].height(), 1);
}

}  // namespace
}  // namespace kickstand::ui
