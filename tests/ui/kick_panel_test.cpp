// Every control of the Kick panel, to the bytes on the wire and back.

#include <QMessageBox>

#include "tests/ui/kick_testing.h"
#include "ui/thunderbots/words.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using Bytes = std::vector<std::uint8_t>;
using wire::DriveBlock;

class KickPanelTest : public KickBench {};

TEST_F(KickPanelTest, AKickOf2400IsTheBytesOfTheProtocolAndItsDropIsShown) {
    armAndCharge();
    type("kickWidth1", QStringLiteral("2400"));
    press("kickFirst");
    EXPECT_EQ(kickOnWire(), (Bytes{0xcb, 0x80, 0x00}));
    EXPECT_EQ(rig.wire().kicks(), std::vector<int>{3});
    ASSERT_TRUE(
        waitUntil([this] { return line("kickNotice").contains(QStringLiteral("charged again in")); }));
    // Charging goes on: how much is left depends on how soon the robot told it.
    const KickRecord kick = rig.snapshot()->kicks->back();
    ASSERT_TRUE(kick.after_V && kick.drop_V());
    EXPECT_NEAR(*kick.after_V, 148, 25);
    EXPECT_TRUE(line("kickNotice").contains(u'\u2192' + (u' ' + ui::capacitorText(*kick.after_V))))
        << line("kickNotice").toStdString();
    EXPECT_EQ(rig.wire().kicks().size(), 1U) << "one press, one kick";
    EXPECT_EQ(line("kickDrop"), u'\u2212' + ui::capacitorText(*kick.drop_V()));
    EXPECT_TRUE(line("kickDropWhat").contains(QStringLiteral("2400"))) << line("kickDropWhat").toStdString();
}

TEST_F(KickPanelTest, EachButtonSendsItsSolenoids) {
    armAndCharge();
    type("kickWidth1", QStringLiteral("2016"));
    type("kickWidth2", QStringLiteral("1024"));
    type("kickOffset", QStringLiteral("320"));
    EXPECT_TRUE(
        line("kickWire").contains(QStringLiteral("t1 63 \u00b7 t2 42 \u00b7 \u0394t 10 \u00b7 flags 1 0")))
        << line("kickWire").toStdString();
    EXPECT_TRUE(line("kickWire").startsWith(QStringLiteral("both on the wire")));
    press("kickBoth");
    EXPECT_EQ(kickOnWire(), (Bytes{0xbf, 0x2a, 0x0a}));
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    press("kickFirst");
    EXPECT_EQ(kickOnWire(), (Bytes{0xbf, 0x80, 0x00}));
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    press("kickSecond");
    EXPECT_EQ(kickOnWire(), (Bytes{0x80, 0xa0, 0x00}));
}

TEST_F(KickPanelTest, WhatIsTypedStaysWhileTheRobotsGoOnAndIsTakenWhenTheFieldIsLeft) {
    QSpinBox* width = field("kickWidth1");
    width->setFocus();
    width->selectAll();
    for (const char digit : {'1', '8', '2', '4'}) {
        QTest::keyClick(width, digit);
        ASSERT_TRUE(rig.settle());
        ASSERT_TRUE(rig.settle());
    }
    EXPECT_EQ(width->text(), QStringLiteral("1824"));
    field("kickWidth2")->setFocus();
    EXPECT_EQ(width->value(), 1824);
    EXPECT_TRUE(line("kickWire").contains(QStringLiteral("t1 57"))) << line("kickWire").toStdString();
}

TEST_F(KickPanelTest, WhatIsOnTheWireIsSaidOfBothOnlyWhereThereAreTwo) {
    type("kickWidth1", QStringLiteral("2400"));
    type("kickWidth2", QStringLiteral("1280"));
    EXPECT_TRUE(line("kickWire").startsWith(QStringLiteral("both on the wire: t1 75")))
        << line("kickWire").toStdString();
    type("kickWidth2", QStringLiteral("0"));
    EXPECT_TRUE(line("kickWire").startsWith(QStringLiteral("on the wire: t1 75")))
        << line("kickWire").toStdString();
}

TEST_F(KickPanelTest, NumbersOffTheGridAreSnappedAndThatIsSaid) {
    type("kickWidth1", QStringLiteral("2390"));
    EXPECT_EQ(field("kickWidth1")->value(), 2400);
    EXPECT_TRUE(line("kickWire").contains(QStringLiteral("2390"))) << line("kickWire").toStdString();
    EXPECT_TRUE(line("kickWire").contains(QStringLiteral("2400")));
    type("kickWidth1", QStringLiteral("1600"));
    EXPECT_FALSE(line("kickWire").contains(QStringLiteral("\u2192")));
    type("kickOffset", QStringLiteral("-33"));
    EXPECT_EQ(field("kickOffset")->value(), -32);
}

TEST_F(KickPanelTest, AnImpossibleTimingSaysWhyAndDisablesTheButtons) {
    arm();
    type("kickWidth1", QStringLiteral("320"));
    type("kickWidth2", QStringLiteral("4064"));
    type("kickOffset", QStringLiteral("64"));
    ASSERT_TRUE(rig.settle());
    for (const char* name : {"kickFirst", "kickSecond", "kickBoth", "autokick"}) {
        EXPECT_FALSE(button(name)->isEnabled()) << name;
        EXPECT_TRUE(button(name)->toolTip().contains(QStringLiteral("4064"))) << name;
    }
    EXPECT_TRUE(line("kickNotice").contains(QStringLiteral("4064"))) << line("kickNotice").toStdString();
}

TEST_F(KickPanelTest, TheReasonStandsOnTheDisabledButtonAndInTheLine) {
    rig.clickRobot(3);
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(button("kickFirst")->isEnabled());
    EXPECT_TRUE(button("kickFirst")->toolTip().contains(QStringLiteral("not armed")));
    EXPECT_TRUE(line("kickNotice").contains(QStringLiteral("not armed")));
    EXPECT_TRUE(line("kickHighVoltageWhy").contains(QStringLiteral("arm the high voltage first")));
    rig.clickRobot(9);
    EXPECT_TRUE(line("kickHighVoltageWhy").contains(QStringLiteral("not heard")));
    EXPECT_TRUE(button("kickFirst")->toolTip().contains(QStringLiteral("not heard")));
    EXPECT_TRUE(line("kickNotice").contains(QStringLiteral("not heard")));
}

TEST_F(KickPanelTest, AKickIsForOneRobotAndAutokickForAllThatAreChosen) {
    rig.clickRobot(1);
    rig.clickRobot(2, Qt::ControlModifier);
    press("kickArm");
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) {
        return snapshot.intents[1].highVoltageArmed && snapshot.intents[2].highVoltageArmed;
    }));
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(button("kickFirst")->isEnabled());
    press("autokick");
    for (const int robot : {1, 2})
        ASSERT_TRUE(rig.waitForBlock(robot, [](const DriveBlock& block) { return block.autokickArmed; }));
}

TEST_F(KickPanelTest, TheLastAutokickOfAllIsToldToWhoeverHasChosenNone) {
    armAndCharge();
    press("autokick");
    rig.simulate("ball", 3, 1);
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.robots[3].autokicks == 1; }));
    rig.clickRobot(3, Qt::ControlModifier);
    EXPECT_TRUE(waitUntil([this] {
        return line("autokickLine").startsWith(QStringLiteral("1 fired")) &&
               line("autokickLine").endsWith(QStringLiteral("by robot 3"));
    })) << line("autokickLine").toStdString();
}

TEST_F(KickPanelTest, AutokickIsArmedWithWhatIsDrawnCountedAndDisarmed) {
    armAndCharge();
    type("kickWidth1", QStringLiteral("1600"));
    press("autokick");
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) {
        return block.autokickArmed && block.autokick == wire::KickTimes{true, true, 50, 0, 0};
    }));
    EXPECT_TRUE(line("autokickLine").contains(QStringLiteral("none yet")));
    rig.simulate("ball", 3, 1);
    ASSERT_TRUE(waitUntil([this] {
        return line("autokickLine").contains(QStringLiteral("1 fired, the last at"));
    })) << line("autokickLine").toStdString();
    const QWidget* words = rig.find<QLabel>(QStringLiteral("autokickLine"));
    EXPECT_GT(words->x(), button("autokick")->geometry().right()) << "whoever sees the button sees the count";
    EXPECT_LT(words->y(), button("autokick")->geometry().bottom());
    EXPECT_TRUE(rig.wire().kicks().empty()) << "it kicks by itself";
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(button("autokick")->isChecked());
    type("kickWidth1", QStringLiteral("3200"));
    ASSERT_TRUE(waitUntil([this] { return line("autokickLine").contains(QStringLiteral("1600 / 0")); }));
    EXPECT_EQ(rig.wire().last(3)->autokick.t1, 50) << "what is drawn later is not armed unasked";
    press("autokick");
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) {
        return !block.autokickArmed && wire::isNoAutokick(block.autokick);
    }));
}

TEST_F(KickPanelTest, AllZeroAutokickCannotBeArmed) {
    arm();
    type("kickWidth1", QStringLiteral("0"));
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(button("autokick")->isEnabled());
    EXPECT_TRUE(button("autokick")->toolTip().contains(QStringLiteral("disarmed")));
}

TEST_F(KickPanelTest, ChargerAndDischargeAreHereTooWithTheirState) {
    arm();
    press("kickCharger");
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.charge; }));
    ASSERT_TRUE(waitUntil([this] { return line("chargeState").contains(QStringLiteral("charging for")); }));
    ASSERT_TRUE(waitUntil([this] { return line("chargeState").contains(QStringLiteral("took")); }))
        << line("chargeState").toStdString();
    press("kickDischarge");
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.charge; }));
    ASSERT_TRUE(waitUntil([this] { return !rig.wire().kickBytes().empty(); }));
    EXPECT_EQ(rig.wire().kickBytes().front(), (Bytes{0x83, 0x80, 0x00})) << "96 µs";
}

TEST_F(KickPanelTest, PullingAnEdgeMovesItAndTheNumbersFollow) {
    type("kickWidth1", QStringLiteral("2400"));
    type("kickWidth2", QStringLiteral("1280"));
    type("kickOffset", QStringLiteral("384"));
    const auto pull = [this](ui::PulseEdge edge, int to_us) {
        ui::PulseHandle* handle = view()->handle(edge);
        const int pixels = static_cast<int>(view()->axis().pixelOf(to_us)) -
                           static_cast<int>(view()->axis().pixelOf(timeOf(view()->pulses(), edge)));
        const QPoint from = handle->rect().center();
        QTest::mousePress(handle, Qt::LeftButton, {}, from);
        // The handle goes with the hand.
        const QPoint to = from + QPoint(pixels, 0);
        QTest::mouseMove(handle, to);
        QTest::mouseRelease(handle, Qt::LeftButton, {}, from);
    };
    pull(ui::PulseEdge::End1, 3200);
    EXPECT_NEAR(field("kickWidth1")->value(), 3200, 64);
    EXPECT_EQ(field("kickWidth1")->value() % 32, 0);
    pull(ui::PulseEdge::Start2, 800);
    EXPECT_NEAR(field("kickOffset")->value(), 800, 64);
    EXPECT_EQ(field("kickOffset")->value() + field("kickWidth2")->value(), 384 + 1280)
        << "the falling edge stays where it is";
    EXPECT_FALSE(view()->handle(ui::PulseEdge::Start1)->isVisible());
}

TEST_F(KickPanelTest, EdgesTakeTheKeyboard) {
    type("kickWidth1", QStringLiteral("1600"));
    type("kickWidth2", QStringLiteral("0"));
    type("kickOffset", QStringLiteral("0"));
    ui::PulseHandle* handle = view()->handle(ui::PulseEdge::End1);
    handle->setFocus();
    QTest::keyClick(handle, Qt::Key_Right);
    EXPECT_EQ(field("kickWidth1")->value(), 1632);
    QTest::keyClick(handle, Qt::Key_PageUp);
    EXPECT_EQ(field("kickWidth1")->value(), 1952);
    QTest::keyClick(handle, Qt::Key_PageDown);
    QTest::keyClick(handle, Qt::Key_Left);
    EXPECT_EQ(field("kickWidth1")->value(), 1600);
    EXPECT_TRUE(handle->accessibleName().contains(QStringLiteral("1600")))
        << handle->accessibleName().toStdString();
}

TEST_F(KickPanelTest, ButtonsCanBeRenamed) {
    rig.find<QAction>(QStringLiteral("kickFirstRename"))->trigger();
    answer(QStringLiteral("Boot"));
    EXPECT_EQ(button("kickFirst")->text(), QStringLiteral("Boot"));
    EXPECT_EQ(rig.settings().value(QStringLiteral("kick/label1")).toString(), QStringLiteral("Boot"));
}

TEST_F(KickPanelTest, PresetsAreSavedChosenRenamedAndDeleted) {
    type("kickWidth1", QStringLiteral("1280"));
    rig.find<QAction>(QStringLiteral("presetSave"))->trigger();
    answer(QStringLiteral("pass"));
    auto* names = rig.find<QComboBox>(QStringLiteral("kickPresets"));
    EXPECT_EQ(names->currentText(), QStringLiteral("pass"));
    type("kickWidth1", QStringLiteral("3200"));
    EXPECT_EQ(names->currentIndex(), 0) << "what is drawn is no preset any more";
    names->setCurrentIndex(names->findText(QStringLiteral("pass")));
    emit names->activated(names->currentIndex());
    EXPECT_EQ(field("kickWidth1")->value(), 1280);
    rig.find<QAction>(QStringLiteral("presetRename"))->trigger();
    answer(QStringLiteral("soft pass"));
    EXPECT_EQ(names->currentText(), QStringLiteral("soft pass"));
    rig.find<QAction>(QStringLiteral("presetDelete"))->trigger();
    EXPECT_EQ(names->count(), 1);
}

TEST_F(KickPanelTest, APresetIsReplacedOnlyWhenAPersonSaysSo) {
    auto* names = rig.find<QComboBox>(QStringLiteral("kickPresets"));
    const auto save = [this](const QString& name) {
        rig.find<QAction>(QStringLiteral("presetSave"))->trigger();
        answer(name);
    };
    type("kickWidth1", QStringLiteral("1280"));
    save(QStringLiteral("pass"));
    save(QStringLiteral("a second name for the same"));
    EXPECT_EQ(names->currentText(), QStringLiteral("a second name for the same"));
    names->setCurrentIndex(names->findText(QStringLiteral("pass")));
    emit names->activated(names->currentIndex());
    EXPECT_EQ(names->currentText(), QStringLiteral("pass")) << "the one that was chosen";
    type("kickWidth1", QStringLiteral("3200"));
    save(QStringLiteral("pass"));
    auto* box = rig.find<QMessageBox>(QStringLiteral("replacePreset"));
    EXPECT_TRUE(box->text().contains(QStringLiteral("pass")));
    box->reject();
    EXPECT_EQ(names->currentIndex(), 0) << "nothing has been replaced";
    ASSERT_TRUE(waitUntil(
        [this] { return rig.window().findChild<QMessageBox*>(QStringLiteral("replacePreset")) == nullptr; }));
    save(QStringLiteral("pass"));
    for (QAbstractButton* button : rig.find<QMessageBox>(QStringLiteral("replacePreset"))->buttons()) {
        if (button->text().contains(QStringLiteral("Replace"))) button->click();
    }
    EXPECT_EQ(names->currentText(), QStringLiteral("pass"));
}

TEST_F(KickPanelTest, StopDisarmsAndThePanelSaysSo) {
    armAndCharge();
    press("autokick");
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.autokickArmed; }));
    rig.press(Qt::Key_Escape);
    ASSERT_TRUE(rig.waitForStop());
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
    EXPECT_FALSE(button("kickFirst")->isEnabled());
    EXPECT_TRUE(line("kickNotice").contains(QStringLiteral("stopped")));
}

TEST_F(KickPanelTest, ClosingThePanelStopsWhatItArmed) {
    arm();
    rig.find<QDockWidget>(QStringLiteral("kick"))->close();
    ASSERT_TRUE(rig.waitForStop());
}

TEST_F(KickPanelTest, EveryControlHasAName) {
    for (const QWidget* widget : panel()->findChildren<QWidget*>()) {
        if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith(QLatin1String("qt_")))
            continue;
        const auto* one = qobject_cast<const QAbstractButton*>(widget);
        EXPECT_TRUE(!widget->accessibleName().isEmpty() || (one != nullptr && !one->text().isEmpty()))
            << widget->metaObject()->className() << " " << widget->objectName().toStdString();
    }
}

}  // namespace
}  // namespace kickstand::test
