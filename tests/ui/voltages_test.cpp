// The Voltages panel: every control, on simulated robots.

#include <QAbstractButton>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <set>

#include "core/thunderbots/wire/faults.h"
#include "tests/ui/bench_rig.h"
#include "ui/plot/time_plot.h"
#include "ui/thunderbots/voltages_contents.h"
#include "ui/thunderbots/voltages_panel.h"
#include "ui/thunderbots/voltages_table.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using namespace std::chrono_literals;

class VoltagesTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        ASSERT_TRUE(rig.settle());
    }

    ui::VoltagesPanel& panel() { return *rig.window().findChild<ui::VoltagesPanel*>(); }
    ui::TimePlot& plot() { return panel().plot(); }
    const std::vector<ui::PlotCurve>& curves() { return plot().state().curves; }
    std::set<int> shownRobots() {
        std::set<int> robots;
        for (const ui::PlotCurve& curve : curves())
            robots.insert(curve.signal.unit);
        return robots;
    }
    QAbstractItemModel& table() {
        return *rig.find<ui::VoltagesTable>(QStringLiteral("curveTable"))->model();
    }
    QString cell(int row, int column) { return table().index(row, column).data().toString(); }
    /// Chooses from one of the panel's menus.
    void choose(const char* menu, const QString& words) {
        auto* shown = rig.find<QMenu>(QString::fromLatin1(menu));
        emit shown->aboutToShow();
        for (QAction* action : shown->actions()) {
            if (action->text().remove(u'&').section(u'\t', 0, 0) != words) continue;
            action->trigger();
            return;
        }
        FAIL() << "no " << words.toStdString();
    }
    bool isChecked(const char* name) {
        return rig.find<QAbstractButton>(QString::fromLatin1(name))->isChecked();
    }

    QTemporaryDir folder;
};

TEST_F(VoltagesTest, WithNoneChosenAllThatAreHeardAreShown) {
    EXPECT_EQ(shownRobots(), (std::set<int>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(plot().state().areas.size(), 2U);
}

TEST_F(VoltagesTest, FollowsTheChoiceOfTheGridUntilRobotsArePinned) {
    rig.clickRobot(3);
    EXPECT_EQ(shownRobots(), (std::set<int>{3}));
    choose("plotRobotsMenu", QStringLiteral("Robot 5"));
    EXPECT_EQ(shownRobots(), (std::set<int>{3, 5}));
    rig.clickRobot(1);
    EXPECT_EQ(shownRobots(), (std::set<int>{3, 5}));
    EXPECT_EQ(rig.settings().value(QStringLiteral("voltages/robots")).toUInt(), maskOf(3) | maskOf(5));
    choose("plotRobotsMenu", QStringLiteral("Those that are chosen"));
    EXPECT_EQ(shownRobots(), (std::set<int>{1}));
    EXPECT_FALSE(rig.settings().contains(QStringLiteral("voltages/robots")));
}

TEST_F(VoltagesTest, PinnedRobotsAreRemembered) {
    rig.settings().setValue(QStringLiteral("voltages/robots"), uint{maskOf(2) | maskOf(4)});
    auto& view = *static_cast<ui::ThunderbotsView*>(rig.bench().systems().views().front().get());
    ui::VoltagesPanel again(rig.bench(), view.choice());
    std::set<int> robots;
    for (const ui::PlotCurve& curve : again.findChild<ui::TimePlot*>()->state().curves)
        robots.insert(curve.signal.unit);
    EXPECT_EQ(robots, (std::set<int>{2, 4}));
}

TEST_F(VoltagesTest, SignalsAreChosenAndRemembered) {
    rig.clickRobot(3);
    choose("plotSignalsMenu", QStringLiteral("Dribbler"));
    choose("plotSignalsMenu", QStringLiteral("Battery"));
    ASSERT_EQ(curves().size(), 2U);
    EXPECT_EQ(curves()[0].signal, (SignalId{3, static_cast<std::uint16_t>(Signal::Capacitor_V)}));
    EXPECT_EQ(curves()[1].signal, (SignalId{3, static_cast<std::uint16_t>(Signal::Dribbler_C)}));
    EXPECT_EQ(rig.settings().value(QStringLiteral("voltages/signals")).toUInt(),
              ui::bitOf(Signal::Capacitor_V) | ui::bitOf(Signal::Dribbler_C));
}

TEST_F(VoltagesTest, SaysWhyItIsEmpty) {
    auto* empty = rig.find<QLabel>(QStringLiteral("voltagesEmpty"));
    EXPECT_FALSE(empty->isVisible());
    choose("plotSignalsMenu", QStringLiteral("Battery"));
    choose("plotSignalsMenu", QStringLiteral("Capacitor"));
    EXPECT_TRUE(empty->isVisible());
    EXPECT_TRUE(empty->text().contains(QStringLiteral("signal")));
}

TEST_F(VoltagesTest, TheTableShowsTheCurrentValueAndTheVisibleSpan) {
    rig.clickRobot(2);
    // Below what it was before: the least value that is seen.
    rig.simulate("battery", 2, 14.5);
    const auto isNear = [this](int column) {
        return std::abs(cell(0, column).section(u' ', 0, 0).toDouble() - 14.5) < 0.1;
    };
    ASSERT_TRUE(waitUntil([&] { return isNear(1); }));
    ASSERT_TRUE(waitUntil([&] { return isNear(2); }));
    EXPECT_EQ(table().rowCount(), 2);
    EXPECT_TRUE(cell(0, 1).endsWith(QStringLiteral("V")));
    EXPECT_GE(cell(0, 3).toDouble(), cell(0, 4).toDouble());
    EXPECT_GE(cell(0, 4).toDouble(), cell(0, 2).toDouble());
}

TEST_F(VoltagesTest, ALostRobotsValuesAreStaleAndItsLiveCapacitorStaysDangerous) {
    rig.clickRobot(4);
    rig.simulate("capacitor", 4, 212);
    ASSERT_TRUE(waitUntil([this] { return cell(1, 1).startsWith(QStringLiteral("21")); }));
    rig.simulate("dead", 4, 1);
    ASSERT_TRUE(waitUntil([this] { return cell(1, 1).endsWith(u'?'); }));
    EXPECT_TRUE(table().index(1, 1).data(ui::CurveTableModel::StaleRole).toBool());
    EXPECT_TRUE(table().index(1, 1).data(ui::CurveTableModel::DangerRole).toBool());
    EXPECT_FALSE(table().index(0, 1).data(ui::CurveTableModel::DangerRole).toBool());
    // Nothing is known any more: the curve has a gap.
    EXPECT_FALSE(plot().valueAt(curves()[0], rig.client().now()));
}

TEST_F(VoltagesTest, ARobotThatWasNeverHeardIsUnknownAndNotZero) {
    rig.clickRobot(9);
    ASSERT_EQ(table().rowCount(), 2);
    for (int column = 1; column < 5; ++column)
        EXPECT_EQ(cell(0, column), QStringLiteral("\u2014")) << column;
}

TEST_F(VoltagesTest, PauseAndFollowAreButtons) {
    rig.click(QStringLiteral("plotPause"));
    EXPECT_FALSE(plot().isFollowing());
    EXPECT_TRUE(isChecked("plotPause"));
    rig.click(QStringLiteral("plotFollow"));
    EXPECT_TRUE(plot().isFollowing());
    EXPECT_TRUE(isChecked("plotFollow"));
}

TEST_F(VoltagesTest, TheSpanIsChosenShownAndRemembered) {
    choose("plotSpanMenu", QStringLiteral("5 min"));
    EXPECT_EQ(plot().state().view.span(), 5min);
    EXPECT_EQ(rig.find<QAbstractButton>(QStringLiteral("plotSpan"))->text(), QStringLiteral("5 min"));
    EXPECT_EQ(rig.settings().value(QStringLiteral("voltages/span_s")).toInt(), 300);
}

TEST_F(VoltagesTest, ValuesAreFittedFromTheMenu) {
    rig.clickRobot(2);
    const ui::ValueRange usual = plot().state().areas[0].range;
    choose("plotSpanMenu", QStringLiteral("Fit what is seen"));
    EXPECT_NE(plot().state().areas[0].range, usual);
    choose("plotSpanMenu", QStringLiteral("Usual range"));
    EXPECT_EQ(plot().state().areas[0].range, usual);
    choose("plotSpanMenu", QStringLiteral("From the oldest"));
    EXPECT_FALSE(plot().isFollowing());
}

TEST_F(VoltagesTest, CursorsChangeWhatTheTableTells) {
    rig.clickRobot(2);
    rig.click(QStringLiteral("plotCursors"));
    EXPECT_TRUE(plot().state().cursors.isShown());
    EXPECT_EQ(table().headerData(2, Qt::Horizontal).toString(), QStringLiteral("A"));
    const TimePoint now = rig.client().now();
    ASSERT_TRUE(waitUntil([&] { return plot().state().view.now() > now; }));
    plot().putCursor(0, now);
    plot().putCursor(1, now);
    EXPECT_EQ(cell(0, 2), cell(0, 3));
    EXPECT_EQ(cell(0, 4).toDouble(), 0);
    rig.click(QStringLiteral("plotCursors"));
    EXPECT_EQ(table().headerData(2, Qt::Horizontal).toString(), QStringLiteral("Min"));
}

TEST_F(VoltagesTest, TheTriggerWaitsForALevelAndStandsStill) {
    rig.clickRobot(2);
    rig.simulate("battery", 2, 16);
    ASSERT_TRUE(waitUntil([this] { return cell(0, 1).startsWith(QStringLiteral("16.0")); }));
    rig.click(QStringLiteral("plotTrigger"));
    rig.find<QComboBox>(QStringLiteral("triggerCurve"))->setCurrentIndex(0);
    rig.find<QComboBox>(QStringLiteral("triggerEdge"))->setCurrentIndex(1);
    rig.find<QDoubleSpinBox>(QStringLiteral("triggerLevel"))->setValue(14.5);
    rig.click(QStringLiteral("triggerArm"));
    auto* state = rig.find<QLabel>(QStringLiteral("triggerState"));
    EXPECT_TRUE(state->text().contains(QStringLiteral("waiting")));
    rig.simulate("battery", 2, 14);
    ASSERT_TRUE(waitUntil([this] { return !plot().isFollowing(); }));
    EXPECT_TRUE(state->text().contains(QStringLiteral("fired at")));
    rig.click(QStringLiteral("plotTrigger"));
    EXPECT_FALSE(plot().state().trigger);
    EXPECT_FALSE(state->isVisible());
}

TEST_F(VoltagesTest, WhatIsSeenIsSavedAsPictureAndAsTable) {
    rig.clickRobot(2);
    const QString picture = folder.filePath(QStringLiteral("p.png"));
    const QString values = folder.filePath(QStringLiteral("v.csv"));
    ASSERT_TRUE(panel().savePicture(picture));
    EXPECT_FALSE(QImage(picture).isNull());
    ASSERT_TRUE(panel().saveValues(values));
    QFile file(values);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readLine().startsWith("time_s,clock,2 battery [V] min,2 battery [V] max,2 capacitor"));
    EXPECT_FALSE(panel().saveValues(folder.filePath(QStringLiteral("missing/v.csv"))));
    EXPECT_TRUE(
        rig.find<QLabel>(QStringLiteral("voltagesMessage"))->text().startsWith(QStringLiteral("Cannot")));
}

TEST_F(VoltagesTest, AskingForAFileBlocksNothingAndCopiesNeedNone) {
    choose("plotSaveMenu", QStringLiteral("Values as CSV\u2026"));
    auto* dialog = rig.find<QFileDialog>(QStringLiteral("plotFile"));
    ASSERT_TRUE(dialog->isVisible());
    EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog));
    dialog->reject();
    choose("plotSaveMenu", QStringLiteral("Copy table"));
    EXPECT_TRUE(QApplication::clipboard()->text().startsWith(QStringLiteral("Curve\tNow\tMin")));
    choose("plotSaveMenu", QStringLiteral("Copy picture"));
    EXPECT_FALSE(QApplication::clipboard()->pixmap().isNull());
}

TEST(VoltagesContents, MarksOfOtherRobotsAreLeftOut) {
    const Mark kick{TimePoint(1s), MarkKind::Kick, 3, 2400};
    ASSERT_TRUE(ui::markWords(kick, maskOf(3)));
    EXPECT_EQ(ui::markWords(kick, maskOf(3))->label, QStringLiteral("kick 2.4 ms"));
    EXPECT_FALSE(ui::markWords(kick, maskOf(4)));
    const Mark stop{TimePoint(1s), MarkKind::Stop, kNoUnit, 1};
    ASSERT_TRUE(ui::markWords(stop, 0));
    EXPECT_EQ(ui::markWords(stop, 0)->tone, ui::MarkTone::Danger);
}

TEST(VoltagesContents, AFaultIsMarkedForTheRobotThatItNamesAndIsNoDanger) {
    const Mark ofRobot{TimePoint(1s), MarkKind::DeviceError, kNoUnit, 44};
    const wire::Fault fault = wire::dongleFault(44);
    ASSERT_EQ(fault.subject, wire::FaultSubject::Robot);
    EXPECT_FALSE(ui::markWords(ofRobot, kAllRobots & ~maskOf(fault.index)));
    const auto words = ui::markWords(ofRobot, maskOf(fault.index));
    ASSERT_TRUE(words);
    EXPECT_EQ(words->label, QStringLiteral("robot %1: fault 44").arg(fault.index));
    EXPECT_EQ(words->tone, ui::MarkTone::Warning);
    const auto ofNone = ui::markWords({TimePoint(1s), MarkKind::DeviceError, kNoUnit, 0}, maskOf(5));
    ASSERT_TRUE(ofNone);
    EXPECT_EQ(ofNone->label, QStringLiteral("fault 0"));
}

TEST(VoltagesContents, EveryKindOfMarkHasWords) {
    for (int kind = 0; kind <= static_cast<int>(MarkKind::UnitLost); ++kind) {
        const auto words = ui::markWords({TimePoint(1s), static_cast<MarkKind>(kind), 3, 7}, kAllRobots);
        ASSERT_TRUE(words) << kind;
        EXPECT_FALSE(words->label.isEmpty()) << kind;
        EXPECT_FALSE(words->words.isEmpty()) << kind;
    }
}

TEST(VoltagesContents, SeveralMarksOfAKindAreToldTogether) {
    for (int kind = 0; kind <= static_cast<int>(MarkKind::UnitLost); ++kind) {
        const QString text = ui::marksText({static_cast<MarkKind>(kind), 5, 3, 2});
        EXPECT_FALSE(text.isEmpty()) << kind;
    }
    EXPECT_EQ(ui::marksText({MarkKind::UnitHeard, 16, 16, 0}), QStringLiteral("16 robots heard"));
    EXPECT_EQ(ui::marksText({MarkKind::UnitLost, 3, 1, 4}), QStringLiteral("robot 4 lost 3 times"));
    EXPECT_EQ(ui::marksText({MarkKind::Kick, 7, 1, 4}), QStringLiteral("7 kicks"));
}

TEST(VoltagesContents, ANumberInAMarksWordsIsSaidToBeARobots) {
    const auto heard = ui::markWords({TimePoint(1s), MarkKind::UnitHeard, 0, 0}, kAllRobots);
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->label, QStringLiteral("robot 0 heard"));
}

TEST(VoltagesContents, EachSignalHasItsAreaAndARobotOneColour) {
    const ui::VoltagesContents contents =
        ui::voltagesContents(maskOf(3) | maskOf(5), ui::bitOf(Signal::Battery_V) | ui::bitOf(Signal::Light));
    ASSERT_EQ(contents.areas.size(), 2U);
    ASSERT_EQ(contents.curves.size(), 4U);
    EXPECT_EQ(contents.curves[0].colour, contents.curves[2].colour);
    EXPECT_NE(contents.curves[0].colour, contents.curves[1].colour);
    EXPECT_EQ(contents.curves[3].area, 1);
}

}  // namespace
}  // namespace kickstand::test
