// Every state has a look, and the look comes from the snapshot.

#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTest>

#include "tests/ui/bench_rig.h"
#include "ui/shell/event_model.h"
#include "ui/thunderbots/robot_tile.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

class StatesTest : public BenchTest {
  protected:
    ui::RobotTile* tile(int robot) { return rig.find<ui::RobotTile>(QStringLiteral("robot%1").arg(robot)); }
    ui::StateLabel* state(int index) {
        return rig.find<ui::StateLabel>(QStringLiteral("state%1").arg(index));
    }
    QAbstractItemModel* events() { return rig.find<QAbstractItemView>(QStringLiteral("eventList"))->model(); }
    bool waitForEvent(const QString& text) {
        return waitUntil([this, text] {
            for (int row = 0; row < events()->rowCount(); ++row) {
                if (events()->index(row, ui::EventModel::Text).data().toString().contains(text)) return true;
            }
            return false;
        });
    }
};

TEST_F(StatesTest, ARunningLinkAndTheEmergencyStopAreSaidInWordsAndShape) {
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(state(0)->tone(), ui::Tone::Good);
    EXPECT_TRUE(state(0)->text().contains(QStringLiteral("running")));
    EXPECT_EQ(state(1)->tone(), ui::Tone::Good);
    EXPECT_TRUE(state(1)->text().contains(QStringLiteral("RUN")));
}

TEST_F(StatesTest, TheEmergencyStopLeavingRunStopsAndIsShown) {
    rig.clickRobot(1);
    rig.simulate("e-stop", -1, 2);
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.eStop == wire::EStop::Stop; }));
    EXPECT_EQ(state(1)->tone(), ui::Tone::Warning);
    ASSERT_TRUE(rig.waitForStop());
    ASSERT_TRUE(rig.rearm());
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(rig.find<QWidget>(QStringLiteral("wheel1"))->isEnabled());
    EXPECT_TRUE(
        rig.find<QLabel>(QStringLiteral("notice"))->text().contains(QStringLiteral("emergency stop")));
}

TEST_F(StatesTest, ReadingsChangeOnTheTile) {
    rig.simulate("battery", 2, 14.5);
    ASSERT_TRUE(waitUntil([this] { return tile(2)->content().batteryWord == QStringLiteral("low"); }));
    rig.simulate("battery", 2, 13.6);
    ASSERT_TRUE(waitUntil([this] { return tile(2)->content().batteryWord == QStringLiteral("empty"); }));
    rig.simulate("ball", 2, 1);
    ASSERT_TRUE(waitUntil([this] { return tile(2)->accessibleName().contains(QStringLiteral("ball")); }));
    EXPECT_TRUE(waitForEvent(QStringLiteral("battery")));
}

TEST_F(StatesTest, ALostRobotKeepsItsLiveCapacitorInRedAndIsNeverFresh) {
    rig.clickRobot(4);
    rig.simulate("capacitor", 4, 212);
    ASSERT_TRUE(waitUntil([this] { return tile(4)->content().capacitorLive; }));
    rig.simulate("dead", 4, 1);
    ASSERT_TRUE(waitUntil([this] { return tile(4)->content().stale; }));
    EXPECT_TRUE(tile(4)->content().capacitorLive);
    EXPECT_TRUE(tile(4)->content().capacitor.endsWith(u'?'));
    EXPECT_TRUE(tile(4)->accessibleName().contains(QStringLiteral("treat as live")));
    EXPECT_TRUE(waitForEvent(QStringLiteral("treat as live")));
    const auto* readout = rig.find<QWidget>(QStringLiteral("capacitor"));
    EXPECT_TRUE(waitUntil(
        [readout] { return readout->accessibleName().contains(QStringLiteral("s ago: treat as live")); }));
}

TEST_F(StatesTest, APulledPlugMakesEverythingStale) {
    rig.simulate("plugged", -1, 0);
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.link == LinkState::Searching; }));
    EXPECT_EQ(state(0)->tone(), ui::Tone::Warning);
    EXPECT_FALSE(rig.find<QLabel>(QStringLiteral("facts"))->text().contains(QStringLiteral("radios")));
    for (int robot = 0; robot < 6; ++robot)
        EXPECT_TRUE(tile(robot)->content().stale) << robot;
    EXPECT_TRUE(rig.find<QWidget>(QStringLiteral("simulatedBanner"))->isVisible());
}

TEST_F(StatesTest, HeardRobotsComeFirst) {
    ASSERT_TRUE(rig.settle());
    rig.simulate("dead", 0, 1);
    ASSERT_TRUE(waitUntil([this] { return tile(0)->content().stale; }));
    // Robot 0 keeps its place: it was heard. Robot 6 never was.
    EXPECT_LT(tile(0)->y(), tile(6)->y());
    EXPECT_FALSE(tile(6)->content().known);
}

TEST_F(StatesTest, EventsAreFilteredByTextRobotAndWeight) {
    rig.simulate("battery", 2, 14.5);
    ASSERT_TRUE(waitForEvent(QStringLiteral("battery low")));
    const int all = events()->rowCount();
    auto* text = rig.find<QLineEdit>(QStringLiteral("eventText"));
    text->setText(QStringLiteral("BATTERY LOW"));
    ASSERT_GT(events()->rowCount(), 0);
    EXPECT_LT(events()->rowCount(), all);
    text->clear();
    auto* whose = rig.find<QComboBox>(QStringLiteral("eventRobot"));
    whose->setCurrentIndex(whose->findData(QStringLiteral("robot 2")));
    ASSERT_GT(events()->rowCount(), 0);
    EXPECT_LT(events()->rowCount(), all);
    for (int row = 0; row < events()->rowCount(); ++row) {
        EXPECT_EQ(events()->index(row, ui::EventModel::Robot).data().toString(), QStringLiteral("robot 2"));
    }
    whose->setCurrentIndex(0);
    rig.find<QComboBox>(QStringLiteral("eventSeverity"))->setCurrentIndex(2);
    for (int row = 0; row < events()->rowCount(); ++row) {
        EXPECT_EQ(events()->index(row, 0).data(ui::EventModel::SeverityRole).toInt(),
                  static_cast<int>(Severity::Danger));
    }
}

TEST_F(StatesTest, TheThemeCanBeChosenAndIsRemembered) {
    const auto choose = [this](const QString& name) {
        for (QAction* action : rig.find<QMenu>(QStringLiteral("viewMenu"))->actions()) {
            if (action->text().remove(u'&') == name) action->trigger();
        }
    };
    choose(QStringLiteral("Dark"));
    EXPECT_TRUE(ui::tokensOf(QApplication::palette()).dark);
    EXPECT_EQ(rig.settings().value(QStringLiteral("look/theme")).toInt(),
              static_cast<int>(ui::ThemeChoice::Dark));
    choose(QStringLiteral("Light"));
    EXPECT_FALSE(ui::tokensOf(QApplication::palette()).dark);
    choose(QStringLiteral("As the system"));
    EXPECT_EQ(rig.theme().choice(), ui::ThemeChoice::System);
}

TEST_F(StatesTest, TheStatusBarNamesTheLink) {
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(rig.find<QLabel>(QStringLiteral("link"))->text(), QStringLiteral("sim:thunderbots?robots=0-5"));
    EXPECT_TRUE(rig.find<QLabel>(QStringLiteral("facts"))->text().contains(QStringLiteral("packets/s")));
}

}  // namespace
}  // namespace kickstand::test
