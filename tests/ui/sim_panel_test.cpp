// Simulated robots: every action of the simulator from a control, and its present value back in it.

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStyleOptionSpinBox>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>

#include "tests/ui/bench_rig.h"
#include "ui/shell/sim_action_control.h"
#include "ui/widgets/segmented.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

class SimPanelTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.bench().goTo(QStringLiteral("simulated"));
        ASSERT_TRUE(choose(2));
    }
    /// A robot's row comes with the next look at the engine.
    bool choose(int robot, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        rig.clickRobot(robot, modifiers);
        return waitUntil([this, robot] {
            return rig.window().findChild<QWidget*>(QStringLiteral("sim-ball-%1").arg(robot)) != nullptr;
        });
    }
    template <class Widget>
    Widget* in(const QString& control) {
        auto* found = rig.find<ui::SimActionControl>(control);
        return found == nullptr ? nullptr : found->findChild<Widget*>();
    }
    static void type(QDoubleSpinBox* box, const QString& text) {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    }
    static void clickStep(QDoubleSpinBox* box, QStyle::SubControl step) {
        QStyleOptionSpinBox option;
        option.initFrom(box);
        option.subControls = QStyle::SC_All;
        option.buttonSymbols = box->buttonSymbols();
        option.frame = box->hasFrame();
        const QRect button = box->style()->subControlRect(QStyle::CC_SpinBox, &option, step, box);
        QTest::mouseClick(box, Qt::LeftButton, {}, button.center());
    }
    /// Of what concerns all robots.
    bool waitForReading(const char* action, double value) {
        return waitUntil([this, action, value] {
            const auto& readings = rig.bench().session()->simReadings;
            return std::any_of(readings.begin(), readings.end(), [&](const SimReading& reading) {
                return reading.action == action && std::abs(reading.value - value) < 1e-6;
            });
        });
    }
    bool waitForRobot(const std::function<bool(const RobotState&)>& holds) {
        return rig.waitForSnapshot([&holds](const Snapshot& snapshot) { return holds(snapshot.robots[2]); });
    }
    bool waitForValue(const QString& control, double value) {
        return waitUntil([&, this] { return std::abs(in<QDoubleSpinBox>(control)->value() - value) < 0.11; });
    }
};

TEST_F(SimPanelTest, ABallIsPutInAndTakenOut) {
    auto* ball = in<ui::Segmented>(QStringLiteral("sim-ball-2"));
    EXPECT_TRUE(waitUntil([ball] { return ball->current() == 1; }));
    ball->button(0)->click();
    EXPECT_TRUE(waitForRobot([](const RobotState& robot) { return robot.readings.ball; }));
    EXPECT_TRUE(waitUntil([ball] { return ball->current() == 0; }));
    ball->button(1)->click();
    EXPECT_TRUE(waitForRobot([](const RobotState& robot) { return !robot.readings.ball; }));
}

TEST_F(SimPanelTest, NumbersAreTypedAndFollowWhatIs) {
    type(in<QDoubleSpinBox>(QStringLiteral("sim-battery-2")), QStringLiteral("14.5"));
    EXPECT_TRUE(waitForRobot(
        [](const RobotState& robot) { return std::abs(robot.readings.battery_V - 14.5) < 0.1; }));
    type(in<QDoubleSpinBox>(QStringLiteral("sim-capacitor-2")), QStringLiteral("120"));
    EXPECT_TRUE(waitForRobot([](const RobotState& robot) { return robot.readings.capacitor_V > 110; }));
    rig.simulate("temperature", 2, 61);
    // It cools from there on.
    const auto* temperature = in<QDoubleSpinBox>(QStringLiteral("sim-temperature-2"));
    EXPECT_TRUE(waitUntil([temperature] { return temperature->value() > 45; })) << temperature->value();
}

TEST_F(SimPanelTest, NumbersAreSteppedWithTheArrowsBesideThem) {
    auto* loss = in<QDoubleSpinBox>(QStringLiteral("sim-loss"));
    ASSERT_EQ(loss->value(), 0);
    clickStep(loss, QStyle::SC_SpinBoxUp);
    EXPECT_TRUE(waitForValue(QStringLiteral("sim-loss"), loss->singleStep()));
    EXPECT_TRUE(waitForReading("loss", loss->singleStep() / 100));
    clickStep(loss, QStyle::SC_SpinBoxDown);
    EXPECT_TRUE(waitForReading("loss", 0));
    EXPECT_EQ(loss->value(), 0);
}

TEST_F(SimPanelTest, TheWheelOverANumberThatIsNotWorkedOnChangesNothing) {
    auto* battery = in<QDoubleSpinBox>(QStringLiteral("sim-battery-2"));
    rig.find<QWidget>(QStringLiteral("robot2"))->setFocus();
    ASSERT_FALSE(battery->hasFocus());
    const double before = battery->value();
    QWheelEvent wheel(QPointF(5, 5), battery->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(battery, &wheel);
    EXPECT_EQ(battery->value(), before);
    EXPECT_FALSE(wheel.isAccepted()) << "it scrolls the panel";
}

TEST_F(SimPanelTest, WhatIsTypedStaysWhileTheRobotsGoOn) {
    auto* battery = in<QDoubleSpinBox>(QStringLiteral("sim-battery-2"));
    battery->setFocus();
    battery->selectAll();
    for (const char key : {'1', '3', '.', '4'}) {
        QTest::keyClick(battery, key);
        for (int i = 0; i < 20; ++i)
            ASSERT_TRUE(rig.settle());
    }
    EXPECT_EQ(battery->text(), QStringLiteral("13.4 V"));
    QTest::keyClick(battery, Qt::Key_Tab);
    EXPECT_TRUE(waitForRobot(
        [](const RobotState& robot) { return std::abs(robot.readings.battery_V - 13.4) < 0.1; }));
}

TEST_F(SimPanelTest, ARobotIsSwitchedOffAndOn) {
    auto* power = in<ui::Segmented>(QStringLiteral("sim-dead-2"));
    power->button(0)->click();
    ASSERT_TRUE(waitForRobot([](const RobotState& robot) { return !robot.live; }));
    EXPECT_TRUE(waitUntil([power] { return power->current() == 0; }));
    power->button(1)->click();
    EXPECT_TRUE(waitForRobot([](const RobotState& robot) { return robot.live; }));
}

TEST_F(SimPanelTest, ExperimentDataIsSent) {
    in<QAbstractButton>(QStringLiteral("sim-experiment-2"))->click();
    EXPECT_TRUE(waitForRobot([](const RobotState& robot) { return robot.experiment.known.all(); }));
}

TEST_F(SimPanelTest, TheEmergencyStopAndThePlug) {
    auto* stop = in<ui::Segmented>(QStringLiteral("sim-e-stop"));
    EXPECT_TRUE(waitUntil([stop] { return stop->current() == 0; }));
    stop->button(1)->click();
    EXPECT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.eStop == wire::EStop::Stop; }));
    auto* plug = in<ui::Segmented>(QStringLiteral("sim-plugged"));
    plug->button(1)->click();
    EXPECT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.link == LinkState::Searching; }));
    EXPECT_TRUE(waitUntil([plug] { return plug->current() == 1; }));
    plug->button(0)->click();
    EXPECT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.link == LinkState::Running; }));
}

TEST_F(SimPanelTest, LossIsAShareInPercent) {
    type(in<QDoubleSpinBox>(QStringLiteral("sim-loss")), QStringLiteral("20"));
    const auto loss = [this] {
        for (const SimReading& reading : rig.bench().session()->simReadings) {
            if (reading.action == "loss") return reading.value;
        }
        return -1.0;
    };
    EXPECT_TRUE(waitUntil([&loss] { return std::abs(loss() - 0.2) < 1e-9; }));
}

TEST_F(SimPanelTest, AnEndpointIsStalledAndACodeQueued) {
    auto* endpoints = in<QComboBox>(QStringLiteral("sim-stall"));
    endpoints->setCurrentIndex(endpoints->findData(0x85));
    in<QAbstractButton>(QStringLiteral("sim-stall"))->click();
    EXPECT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.traffic.stalls > 0; }));
    in<QDoubleSpinBox>(QStringLiteral("sim-error"))->setValue(40);
    in<QAbstractButton>(QStringLiteral("sim-error"))->click();
    EXPECT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.traffic.dongleErrors > 0; }));
}

TEST_F(SimPanelTest, EachChosenRobotHasARow) {
    EXPECT_TRUE(choose(4, Qt::ControlModifier));
    EXPECT_NE(rig.find<ui::SimActionControl>(QStringLiteral("sim-ball-2")), nullptr);
    rig.clickRobot(9);
    EXPECT_TRUE(waitUntil([this] { return rig.find<QLabel>(QStringLiteral("simHint"))->isVisible(); }));
    EXPECT_EQ(rig.window().findChild<QWidget*>(QStringLiteral("sim-ball-9")), nullptr);
}

TEST_F(SimPanelTest, RowsThatAreTooWideLeaveWhatConcernsAllInSight) {
    rig.window().resize(1280, 800);
    ASSERT_TRUE(choose(4, Qt::ControlModifier));
    ASSERT_TRUE(rig.settle());
    const auto* panel = rig.find<QWidget>(QStringLiteral("simulated"));
    for (const SimAction& action : rig.bench().session()->simActions) {
        if (action.perUnit) continue;
        const auto* control = rig.find<QWidget>(QStringLiteral("sim-") + QString::fromStdString(action.name));
        const QRect place(control->mapTo(panel, QPoint()), control->size());
        EXPECT_GE(place.left(), 0) << action.name;
        EXPECT_LE(place.right(), panel->width()) << action.name;
    }
}

TEST_F(SimPanelTest, TheMenuOfTheBannerDoesTheSameToThoseThatAreChosen) {
    QMenu* menu = rig.find<QPushButton>(QStringLiteral("simMenu"))->menu();
    const auto entry = [](QMenu* in, const QString& text) {
        emit in->aboutToShow();
        for (QAction* action : in->actions()) {
            if (action->text().contains(text)) return action;
        }
        return static_cast<QAction*>(nullptr);
    };
    QAction* ball = entry(menu, QStringLiteral("Ball"));
    ASSERT_NE(ball, nullptr);
    ASSERT_NE(ball->menu(), nullptr);
    ball->menu()->actions().front()->trigger();
    EXPECT_TRUE(waitForRobot([](const RobotState& robot) { return robot.readings.ball; }));
    QAction* battery = entry(menu, QStringLiteral("Battery"));
    ASSERT_NE(battery, nullptr);
    battery->trigger();
    auto* dialog = rig.window().findChild<QInputDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->setDoubleValue(13.5);
    dialog->accept();
    EXPECT_TRUE(waitForRobot([](const RobotState& robot) { return robot.readings.battery_V < 13.8; }));
}

TEST_F(SimPanelTest, EveryActionOfTheSimulatorHasAControl) {
    for (const SimAction& action : rig.bench().session()->simActions) {
        const QString id = QStringLiteral("sim-") + QString::fromStdString(action.name);
        EXPECT_NE(rig.find<ui::SimActionControl>(action.perUnit ? id + QStringLiteral("-2") : id), nullptr);
    }
}

TEST(SimPanel, IsNotThereForHardware) {
    BenchRig rig;
    ASSERT_TRUE(rig.connectTo("usb:"));
    EXPECT_FALSE(rig.find<QDockWidget>(QStringLiteral("simulated"))->isVisible());
    ASSERT_TRUE(rig.connectTo());
    EXPECT_TRUE(
        waitUntil([&rig] { return !rig.find<QDockWidget>(QStringLiteral("simulated"))->isHidden(); }));
}

}  // namespace
}  // namespace kickstand::test
