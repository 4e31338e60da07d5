// STOP: by button and by key, wherever the focus is, and what the window shows of it.

#include <QAbstractSlider>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/bench_rig.h"
#include "ui/shell/suspend_watch.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/set_point_slider.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using wire::DriveBlock;

class StopTest : public BenchTest {
  protected:
    /// Robot 3 drives and dribbles.
    void drive() {
        rig.clickRobot(3);
        rig.typeWheel(1, QStringLiteral("30"));
        ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 30; }));
        rig.click(QStringLiteral("dribbler"));
        ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.dribble; }));
        ASSERT_TRUE(rig.settle());
    }
    void expectBraked() {
        EXPECT_TRUE(rig.client().isStopped());
        EXPECT_TRUE(
            rig.waitForBlock(3, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
        // All sixteen, whatever is known of them.
        for (int robot = 0; robot < kRobots; ++robot) {
            EXPECT_TRUE(rig.waitForBlock(robot, [](const DriveBlock& b) { return b == wire::brakedBlock(); }))
                << robot;
        }
    }
    ui::Banner* banner() { return rig.find<ui::Banner>(QStringLiteral("stoppedBanner")); }
};

TEST_F(StopTest, TheButtonStopsWhenItIsPressedNotWhenItIsLetGo) {
    drive();
    QTest::mousePress(rig.find<QWidget>(QStringLiteral("stop")), Qt::LeftButton);
    expectBraked();
    QTest::mouseRelease(rig.find<QWidget>(QStringLiteral("stop")), Qt::LeftButton);
    EXPECT_TRUE(rig.client().isStopped());
}

TEST_F(StopTest, SpaceStopsWithTheFocusOnAButtonAndDoesNotPressIt) {
    drive();
    auto* zero = rig.find<QAbstractButton>(QStringLiteral("zero"));
    QSignalSpy pressed(zero, &QAbstractButton::clicked);
    zero->setFocus();
    rig.press(Qt::Key_Space);
    expectBraked();
    EXPECT_EQ(pressed.count(), 0);
}

TEST_F(StopTest, SpaceStopsWithTheFocusInATextWhileSomethingMoves) {
    drive();
    auto* text = rig.find<QLineEdit>(QStringLiteral("eventText"));
    text->setFocus();
    rig.press(Qt::Key_Space);
    expectBraked();
    EXPECT_TRUE(text->text().isEmpty());
}

TEST_F(StopTest, SpaceTypesASpaceIntoATextWhileNothingMoves) {
    auto* text = rig.find<QLineEdit>(QStringLiteral("eventText"));
    text->setFocus();
    ASSERT_TRUE(rig.settle());
    QTest::keyClicks(text, QStringLiteral("robot"));
    rig.press(Qt::Key_Space);
    EXPECT_EQ(text->text(), QStringLiteral("robot "));
    EXPECT_FALSE(rig.client().isStopped());
}

TEST_F(StopTest, SpaceStopsInATextWhileHighVoltageIsArmed) {
    rig.clickRobot(3);
    rig.click(QStringLiteral("arm"));
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.intents[3].highVoltageArmed; }));
    rig.find<QLineEdit>(QStringLiteral("eventText"))->setFocus();
    rig.press(Qt::Key_Space);
    EXPECT_TRUE(rig.client().isStopped());
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& snapshot) { return !snapshot.intents[3].highVoltageArmed; }));
}

TEST_F(StopTest, SpaceIsStopInANumberFieldEvenAtRest) {
    rig.clickRobot(3);
    ASSERT_TRUE(rig.settle());
    rig.find<QWidget>(QStringLiteral("wheel1"))->findChild<QLineEdit*>()->setFocus();
    rig.press(Qt::Key_Space);
    EXPECT_TRUE(rig.client().isStopped());
}

TEST_F(StopTest, SpaceAndEscStopAheadOfAModalDialogWhichStays) {
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Escape}) {
        drive();
        QMessageBox dialog(QMessageBox::NoIcon, QStringLiteral("modal"), QStringLiteral("modal"),
                           QMessageBox::Ok, &rig.window());
        dialog.setModal(true);
        dialog.show();
        QTest::keyClick(&dialog, key);
        expectBraked();
        EXPECT_TRUE(dialog.isVisible());
        dialog.close();
        ASSERT_TRUE(rig.rearm());
        rig.wire().clear();
    }
}

TEST_F(StopTest, EscClosesADialogWhileNothingMovesAndStopsOtherwise) {
    ASSERT_TRUE(rig.settle());
    QMessageBox dialog(QMessageBox::NoIcon, QStringLiteral("modal"), QStringLiteral("modal"), QMessageBox::Ok,
                       &rig.window());
    dialog.setModal(true);
    dialog.show();
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_FALSE(rig.client().isStopped());
    rig.press(Qt::Key_Escape);
    EXPECT_TRUE(rig.client().isStopped());
}

TEST_F(StopTest, SpaceStopsWhileAMenuIsOpen) {
    drive();
    auto* menu = rig.find<QMenu>(QStringLiteral("viewMenu"));
    menu->popup(QPoint(0, 0));
    QTest::keyClick(menu, Qt::Key_Space);
    expectBraked();
    menu->close();
}

TEST_F(StopTest, TheWindowSaysWhyAndWhatCannotBeTakenBackAndDrivesNothing) {
    drive();
    EXPECT_FALSE(banner()->isVisible());
    rig.press(Qt::Key_Space);
    EXPECT_TRUE(banner()->isVisible());
    EXPECT_TRUE(banner()->text().contains(QStringLiteral("STOPPED")));
    EXPECT_TRUE(banner()->text().contains(QStringLiteral("kick")));
    EXPECT_EQ(rig.find<QAbstractButton>(QStringLiteral("stop"))->text(), QStringLiteral("STOPPED"));
    auto* wheel = rig.find<ui::SetPointSlider>(QStringLiteral("wheel1"));
    EXPECT_FALSE(wheel->isEnabled());
    EXPECT_EQ(wheel->value(), 0);
}

TEST_F(StopTest, RearmingIsASeparateActAndNothingStartsByIt) {
    drive();
    rig.press(Qt::Key_Space);
    expectBraked();
    auto* rearm = rig.find<QPushButton>(QStringLiteral("rearm"));
    EXPECT_FALSE(rearm->hasFocus());
    EXPECT_FALSE(rearm->isDefault());
    EXPECT_FALSE(rearm->autoDefault());
    rig.wire().clear();
    rig.click(QStringLiteral("rearm"));
    EXPECT_FALSE(rig.client().isStopped());
    EXPECT_FALSE(banner()->isVisible());
    ASSERT_TRUE(rig.settle());
    for (const DriveBlock& block : rig.wire().blocks(3))
        EXPECT_EQ(block, wire::brakedBlock());
    EXPECT_EQ(rig.find<ui::SetPointSlider>(QStringLiteral("wheel1"))->value(), 0);
    rig.typeWheel(1, QStringLiteral("8"));
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 8; }));
}

TEST_F(StopTest, RearmingHasAKeyOfItsOwn) {
    rig.press(Qt::Key_Space);
    ASSERT_TRUE(rig.client().isStopped());
    rig.press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(rig.client().isStopped());
}

TEST_F(StopTest, RearmingWaitsForTheEmergencyStop) {
    rig.simulate("e-stop", -1, 2);
    ASSERT_TRUE(rig.waitForStop());
    auto* rearm = rig.find<QPushButton>(QStringLiteral("rearm"));
    ASSERT_TRUE(waitUntil([rearm] { return rearm->isVisible() && !rearm->isEnabled(); }));
    rig.press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(rig.client().isStopped());
    rig.simulate("e-stop", -1, 3);
    ASSERT_TRUE(waitUntil([rearm] { return rearm->isEnabled(); }));
    EXPECT_TRUE(rig.client().isStopped()) << "the switch alone takes nothing back";
    rig.press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(rig.client().isStopped());
}

TEST_F(StopTest, ASliderThatIsHeldIsTakenOutOfTheHand) {
    rig.clickRobot(3);
    auto* slider = rig.find<QWidget>(QStringLiteral("wheel1"))->findChild<QAbstractSlider*>();
    QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, 10));
    QTest::mouseMove(slider, QPoint(slider->width() / 2 + 40, 10));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] > 0; }));
    rig.press(Qt::Key_Space);
    expectBraked();
    ASSERT_TRUE(rig.rearm());
    rig.wire().clear();
    // The button is still down, and moves on: that must not count.
    QTest::mouseMove(slider, QPoint(slider->width() / 2 + 80, 10));
    ASSERT_TRUE(rig.settle());
    for (const DriveBlock& block : rig.wire().blocks(3))
        EXPECT_EQ(block, wire::brakedBlock());
}

TEST_F(StopTest, LosingTheKeyboardWhileSomethingMovesStops) {
    drive();
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    expectBraked();
    EXPECT_EQ(rig.client().stopReason(), StopReason::FocusLost);
}

TEST_F(StopTest, LosingTheKeyboardAtRestOrWithTheSettingOffDoesNot) {
    ASSERT_TRUE(rig.settle());
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    EXPECT_FALSE(rig.client().isStopped());
    drive();
    for (QAction* action : rig.find<QMenu>(QStringLiteral("viewMenu"))->actions()) {
        if (action->objectName() == QStringLiteral("focusSetting")) action->setChecked(false);
    }
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    EXPECT_FALSE(rig.client().isStopped());
}

TEST_F(StopTest, LosingTheKeyboardWhileARobotIsOnlyAskedSomethingDoesNot) {
    rig.bench().submit(SystemCommand{thunderbots::Command{ReadSignatures{3}}}, nullptr, {});
    EXPECT_TRUE(rig.client().hasPending());
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    EXPECT_FALSE(rig.client().isStopped());
    rig.bench().submit(SystemCommand{thunderbots::Command{SetWheels{1U << 3, {30, 0, 0, 0}}}}, nullptr, {});
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    EXPECT_TRUE(rig.client().isStopped()) << "what may move a robot is not in the snapshot yet";
}

TEST_F(StopTest, LosingTheKeyboardWithTheHighVoltageArmedAloneDoesNot) {
    rig.clickRobot(3);
    rig.click(QStringLiteral("arm"));
    ASSERT_TRUE(rig.settle());
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    EXPECT_FALSE(rig.client().isStopped());
}

TEST_F(StopTest, ClosingThePanelThatDrivesStopsWhatMoves) {
    drive();
    QAction* toggle = rig.find<QDockWidget>(QStringLiteral("drive"))->toggleViewAction();
    toggle->trigger();
    expectBraked();
    EXPECT_EQ(rig.client().stopReason(), StopReason::PanelClosed);
    toggle->trigger();
    EXPECT_TRUE(rig.find<QDockWidget>(QStringLiteral("drive"))->isVisible());
}

TEST_F(StopTest, ClosingAPanelThatOnlyShowsDoesNotStop) {
    drive();
    rig.find<QDockWidget>(QStringLiteral("events"))->toggleViewAction()->trigger();
    EXPECT_FALSE(rig.client().isStopped());
}

TEST_F(StopTest, TheMachineGoingToSleepIsToldBeforeIt) {
    ui::SuspendWatch watch;
    QSignalSpy sleeps(&watch, &ui::SuspendWatch::aboutToSleep);
    watch.prepareForSleep(true);
    EXPECT_EQ(sleeps.count(), 1);
    watch.prepareForSleep(false);
    EXPECT_EQ(sleeps.count(), 1);
}

TEST_F(StopTest, AHeldSpaceStopsOnceAndRearmingWinsAfterwards) {
    rig.press(Qt::Key_Space);
    ASSERT_TRUE(rig.rearm());
    QKeyEvent repeated(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), true);
    QApplication::sendEvent(&rig.window(), &repeated);
    EXPECT_FALSE(rig.client().isStopped());
}

}  // namespace
}  // namespace kickstand::test
