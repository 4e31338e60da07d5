// The panels of the smart devices in the whole window, on simulated boards: from the editor to the bytes on
// the wire and back.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <set>

#include "tests/ui/board_window.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/sim_action_control.h"
#include "ui/smartdevice/device_list.h"
#include "ui/smartdevice/parameter_editor.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/center_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::test {
namespace {

using smartdevice::Presence;
using smartdevice::WriteVerdict;

class BoardsTest : public BoardWindow {};

TEST_F(BoardsTest, ListsEveryBoardWithItsKindPlaceLatencyAndStanding) {
    connectTo("PolarBear,BatteryBuzzer,Encoder.hibike");
    std::set<QString> kinds;
    for (int row = 0; row < 3; ++row) {
        kinds.insert(line(row).kind);
        EXPECT_TRUE(line(row).place.contains(QStringLiteral("simulated-"))) << row;
        ASSERT_TRUE(waitFor([&] { return line(row).median.endsWith(QStringLiteral(" ms")); }));
        EXPECT_TRUE(line(row).p99.startsWith(QStringLiteral("p99 ")));
        EXPECT_EQ(line(row).standing, (ui::Standing{ui::Tone::Good, QStringLiteral("live")}));
    }
    EXPECT_EQ(kinds, (std::set<QString>{QStringLiteral("PolarBear"), QStringLiteral("BatteryBuzzer"),
                                        QStringLiteral("Encoder")}));
    EXPECT_TRUE(text(QStringLiteral("boardsRemedy")).isEmpty());
}

TEST_F(BoardsTest, TheConnectMenuKeepsHardwareApartFromWhatIsSimulated) {
    connectTo("PolarBear");
    auto* menu = find<QMenu>(QStringLiteral("connectMenu"));
    menu->popup(QPoint(0, 0));
    QString section;
    QString hardware;
    QString simulated;
    for (const QAction* action : menu->actions()) {
        if (action->isSeparator()) section = action->text();
        if (action->text() == QStringLiteral("Smart devices on USB")) hardware = section;
        if (action->text() == QStringLiteral("Six simulated smart devices")) simulated = section;
    }
    menu->close();
    EXPECT_EQ(hardware, QStringLiteral("Hardware to look for"));
    EXPECT_EQ(simulated, QStringLiteral("Simulated"));
}

TEST_F(BoardsTest, ASliderWritesItsParameterAndShowsWhatTheBoardHas) {
    connectTo("PolarBear");
    choose(QStringLiteral("PolarBear"));
    type(0, QStringLiteral("0.5"));
    // Parameter 0 = 0.5f: the vector of the protocol.
    ASSERT_TRUE(waitForWrite("14 06 01 00 00 00 00 3f 2c"));
    ASSERT_TRUE(waitFor([&] { return device(0).parameters[0].verdict == WriteVerdict::Done; }));
    ASSERT_TRUE(waitFor([&] { return verdict(0) == QStringLiteral("done"); }));
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value0")) == QStringLiteral("0.500"); }));
    EXPECT_TRUE(bench->isMoving());
    auto* slider = editor(0)->findChild<ui::CenterSlider*>();
    ASSERT_TRUE(waitFor([&] { return slider->value() == 50; }));
    emit slider->zeroAsked();
    ASSERT_TRUE(waitForWrite("14 06 01 00 00 00 00 00 13"));
    ASSERT_TRUE(waitFor([&] { return !bench->isMoving(); }));
    slider->setValue(-100);
    ASSERT_TRUE(waitForWrite("14 06 01 00 00 00 80 bf 2c"));
}

TEST_F(BoardsTest, OfASliderThatIsPulledTheNewestValueArrives) {
    connectTo("ServoControl");
    choose(QStringLiteral("ServoControl"));
    auto* slider = editor(1)->findChild<ui::CenterSlider*>();
    slider->setSliderDown(true);
    for (int step = 1; step <= 60; ++step)
        slider->setSliderPosition(step);
    slider->setSliderDown(false);
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value1")) == QStringLiteral("0.600"); }));
    EXPECT_LT(writes.messages().size(), 60U);
    ASSERT_TRUE(waitFor([&] { return verdict(1) == QStringLiteral("done"); }));
    EXPECT_EQ(slider->value(), 60);
}

TEST_F(BoardsTest, ASwitchWritesAndIsTurnedByTheBoardAlone) {
    connectTo("TeamFlag");
    choose(QStringLiteral("TeamFlag"));
    const auto buttons = editor(1)->findChildren<QPushButton*>();
    ASSERT_EQ(buttons.size(), 2);
    EXPECT_EQ(buttons[1]->accessibleName(), QStringLiteral("blue: On"));
    buttons[1]->click();
    ASSERT_TRUE(waitForWrite("14 03 02 00 01 14"));
    ASSERT_TRUE(waitFor([&] { return buttons[1]->isChecked(); }));
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value1")) == QStringLiteral("on"); }));
    buttons[0]->click();
    ASSERT_TRUE(waitForWrite("14 03 02 00 00 15"));
    ASSERT_TRUE(waitFor([&] { return buttons[0]->isChecked(); }));
}

TEST_F(BoardsTest, AWriteOnlyNumberIsMarkedSentAndStaysUnconfirmed) {
    connectTo("PolarBear");
    choose(QStringLiteral("PolarBear"));
    EXPECT_EQ(text(QStringLiteral("mark2")), QStringLiteral("write only"));
    EXPECT_EQ(text(QStringLiteral("value2")), QStringLiteral("\u2014"));
    EXPECT_TRUE(find<QCheckBox>(QStringLiteral("update2"))->isHidden());
    type(2, QStringLiteral("1,5"));
    ASSERT_TRUE(waitForWrite("14 06 04 00 00 00 c0 3f e9"));
    ASSERT_TRUE(waitFor([&] { return verdict(2) == QStringLiteral("sent, unconfirmed"); }));
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value2")) == QStringLiteral("set to 1.500"); }));
    EXPECT_FALSE(find<QLabel>(QStringLiteral("mark2"))->isHidden());
}

TEST_F(BoardsTest, WhatIsNoValueOrOutOfRangeIsSaidAndNotSent) {
    connectTo("PolarBear");
    choose(QStringLiteral("PolarBear"));
    type(9, QStringLiteral("much"));
    ASSERT_TRUE(waitFor([&] { return verdict(9) == QStringLiteral("not sent"); }));
    EXPECT_TRUE(text(QStringLiteral("boardNotice")).contains(QStringLiteral("current_thresh")));
    // It has a lower bound alone, which the engine keeps.
    type(9, QStringLiteral("-1"));
    ASSERT_TRUE(waitFor([&] { return !client->hasPending(); }));
    ASSERT_TRUE(waitFor([&] { return verdict(9) == QStringLiteral("not sent"); }));
    EXPECT_TRUE(waitFor([&] {
        return text(QStringLiteral("boardNotice")).contains(QStringLiteral("at least 0"));
    })) << text(QStringLiteral("boardNotice")).toStdString();
    EXPECT_TRUE(writes.messages().empty());
    type(9, QStringLiteral("2"));
    ASSERT_TRUE(waitForWrite("14 06 00 02 00 00 00 40 50"));
    ASSERT_TRUE(waitFor([&] { return verdict(9) == QStringLiteral("sent, unconfirmed"); }));
}

TEST_F(BoardsTest, WhatCanOnlyBeReadIsGreyedAndHasNoEditor) {
    connectTo("LimitSwitch");
    choose(QStringLiteral("LimitSwitch"));
    EXPECT_EQ(window->findChild<ui::ParameterEditor*>(QStringLiteral("editor0")), nullptr);
    simulate("switches", 0, 1);
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value0")) == QStringLiteral("on"); }));
}

TEST_F(BoardsTest, ARefusedWriteIsSaidInWords) {
    connectTo("TeamFlag");
    choose(QStringLiteral("TeamFlag"));
    simulate("refuse", 0, 1);
    ASSERT_TRUE(waitFor([&] { return !bench->session()->simReadings.empty(); }));
    ASSERT_TRUE(waitFor([&] {
        return std::ranges::any_of(bench->session()->simReadings, [](const SimReading& reading) {
            return reading.action == "refuse" && reading.value == 1;
        });
    }));
    editor(3)->findChildren<QPushButton*>()[1]->click();
    ASSERT_TRUE(waitFor([&] { return verdict(3) == QStringLiteral("refused"); }));
    EXPECT_TRUE(text(QStringLiteral("boardNotice")).contains(QStringLiteral("did not take led1")));
}

TEST_F(BoardsTest, StopZeroesDisablesAndBlocksWritingUntilRearmed) {
    connectTo("PolarBear");
    choose(QStringLiteral("PolarBear"));
    type(0, QStringLiteral("0.5"));
    ASSERT_TRUE(waitFor([&] { return device(0).driving; }));
    client->stop(StopReason::Person);
    // Zero to the duty cycle and to the speed, then disable.
    ASSERT_TRUE(waitForWrite("16 00 16"));
    const auto all = writes.messages();
    EXPECT_EQ(all[all.size() - 2], "14 0a 21 00 00 00 00 00 00 00 00 00 3f");
    auto* banner = find<ui::Banner>(QStringLiteral("boardBlocked"));
    ASSERT_TRUE(waitFor([&] { return !banner->isHidden() && !editor(0)->isEnabled(); }));
    EXPECT_EQ(line(0).standing.text, QStringLiteral("disabled"));
    client->rearm();
    ASSERT_TRUE(waitFor([&] { return banner->isHidden() && editor(0)->isEnabled(); }));
    EXPECT_EQ(writes.last(), "16 00 16");
    type(0, QStringLiteral("0.25"));
    ASSERT_TRUE(waitForWrite("14 06 01 00 00 00 80 3e ad"));
}

TEST_F(BoardsTest, OneBoardIsDisabledAndClosingThePanelDisablesWhatItDrives) {
    connectTo("PolarBear,TeamFlag");
    choose(QStringLiteral("PolarBear"));
    type(0, QStringLiteral("0.5"));
    ASSERT_TRUE(waitFor([&] { return bench->isMoving(); }));
    click(QStringLiteral("boardDisable"));
    ASSERT_TRUE(waitForWrite("16 00 16"));
    ASSERT_TRUE(waitFor([&] { return !bench->isMoving(); }));
    EXPECT_EQ(writes.messages().size(), 2U);
    type(0, QStringLiteral("0.25"));
    ASSERT_TRUE(waitFor([&] { return bench->isMoving(); }));
    find<ui::PanelDock>(QStringLiteral("board"))->close();
    ASSERT_TRUE(waitForWrite("16 00 16"));
}

TEST_F(BoardsTest, UpdatesAreChosenPerBoardAndWhatIsGrantedIsShown) {
    connectTo("BatteryBuzzer");
    choose(QStringLiteral("BatteryBuzzer"));
    ASSERT_TRUE(waitFor([&] {
        return text(QStringLiteral("boardGranted")) ==
               QStringLiteral("granted: 8 of 8 parameters, every 40 ms");
    }));
    find<QCheckBox>(QStringLiteral("update1"))->click();
    ASSERT_TRUE(waitFor([&] { return device(0).subscribed == 0xFD; }));
    find<QSpinBox>(QStringLiteral("boardDelay"))->setValue(20);
    ASSERT_TRUE(waitFor([&] {
        return text(QStringLiteral("boardGranted")) ==
               QStringLiteral("granted: 7 of 7 parameters, every 20 ms");
    }));
    // What is not sent any more is shown with its age.
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value1")).contains(QStringLiteral("ago")); }));
    find<QSpinBox>(QStringLiteral("boardDelay"))->setValue(0);
    ASSERT_TRUE(waitFor([&] { return device(0).delay_ms == 0; }));
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value5")).contains(QStringLiteral("ago")); }));
    const auto before = device(0).samples;
    click(QStringLiteral("boardRead"));
    ASSERT_TRUE(waitFor([&] { return device(0).samples > before; }));
}

TEST_F(BoardsTest, ANameOfItsOwnIsKeptWithTheUid) {
    connectTo("PolarBear");
    choose(QStringLiteral("PolarBear"));
    auto* name = find<QLineEdit>(QStringLiteral("boardName"));
    name->setFocus();
    name->setText(QStringLiteral("left arm"));
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return line(0).title == QStringLiteral("left arm"); }));
    EXPECT_EQ(settings->value(QStringLiteral("smartdevice/names/0c-08-01131415161718191a")).toString(),
              QStringLiteral("left arm"));
    name->clear();
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return line(0).title == QStringLiteral("PolarBear"); }));
}

TEST_F(BoardsTest, ASilentBoardIsLostAndThePulledOneSaysWhatToDo) {
    connectTo("TeamFlag");
    choose(QStringLiteral("TeamFlag"));
    simulate("plugged", 0, 0);
    ASSERT_TRUE(waitFor([&] { return line(0).standing.text.startsWith(QStringLiteral("lost")); }));
    EXPECT_TRUE(text(QStringLiteral("boardsRemedy")).contains(QStringLiteral("check its cable")));
    ASSERT_TRUE(waitFor([&] { return !editor(0)->isEnabled(); }));
    EXPECT_TRUE(text(QStringLiteral("value0")).contains(QStringLiteral("ago")));
    writes.clear();
    simulate("plugged", 0, 1);
    ASSERT_TRUE(waitFor([&] { return line(0).standing.text == QStringLiteral("live"); }));
    EXPECT_TRUE(writes.messages().empty());
}

TEST_F(BoardsTest, APortWhereNobodyAnswersSaysSoAndIsSearchedAgain) {
    connectTo("TeamFlag,LimitSwitch");
    // Nothing but a port is left of a board that nobody has ever heard.
    bench->disconnectAll();
    ASSERT_TRUE(waitFor([&] { return bench->session() == nullptr; }));
    bench->connectTo(*parseLinkUri("sim:smartdevice?devices=TeamFlag&boot_ms=9000"));
    ASSERT_TRUE(waitFor([&] {
        auto* list = find<ui::DeviceList>(QStringLiteral("boards"));
        return list->count() == 1 && line(0).standing.text == QStringLiteral("silent");
    }));
    EXPECT_EQ(line(0).device, -1);
    EXPECT_TRUE(
        text(QStringLiteral("boardsRemedy")).contains(QStringLiteral("Nobody answers at simulated-0")));
    click(QStringLiteral("boardsSearch"));
    ASSERT_TRUE(waitFor([&] { return line(0).standing.text != QStringLiteral("silent"); }));
}

TEST_F(BoardsTest, TheChosenBoardIsSimulatedFromOutsideTheWire) {
    connectTo("BatteryBuzzer,LimitSwitch");
    bench->goTo(QStringLiteral("simulated"));
    choose(QStringLiteral("BatteryBuzzer"));
    const auto control = [&](const char* action, int unit) {
        return window->findChild<ui::SimActionControl*>(
            QStringLiteral("sim-%1-%2").arg(QLatin1String(action)).arg(unit));
    };
    // Its own quantities, and the faults that all have; those of other kinds are left out.
    ASSERT_TRUE(
        waitFor([&] { return control("battery", 0) != nullptr && control("switches", 0) == nullptr; }));
    for (const char* fault :
         {"plugged", "reset", "silent", "noise", "checksum", "truncate", "refuse", "imbalance"})
        EXPECT_NE(control(fault, 0), nullptr) << fault;
    auto* volts = control("battery", 0)->findChild<QDoubleSpinBox*>();
    volts->setValue(10.0);
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value0")) == QStringLiteral("on"); }));
    control("noise", 0)->findChild<QDoubleSpinBox*>()->setValue(50);
    ASSERT_TRUE(waitFor([&] { return device(0).line.faults() > 3; }));
    EXPECT_TRUE(bench->view()->facts(*bench->session()).join(u' ').contains(QStringLiteral("damaged")));
    control("noise", 0)->findChild<QDoubleSpinBox*>()->setValue(0);
    choose(QStringLiteral("LimitSwitch"));
    ASSERT_TRUE(
        waitFor([&] { return control("switches", 1) != nullptr && control("battery", 1) == nullptr; }));
    control("silent", 1)->findChildren<QPushButton*>()[1]->click();
    ASSERT_TRUE(waitFor([&] { return line(1).standing.text.startsWith(QStringLiteral("lost")); }));
}

TEST_F(BoardsTest, EveryControlHasANameAndTakesTheKeyboard) {
    connectTo("PolarBear");
    choose(QStringLiteral("PolarBear"));
    int controls = 0;
    for (const char* id : {"boards-list", "board"}) {
        for (const QWidget* widget : find<ui::PanelDock>(QLatin1String(id))->findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const bool own = qobject_cast<const QLineEdit*>(widget) != nullptr &&
                             qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) == nullptr;
            const bool control = button != nullptr || own ||
                                 qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
                                 qobject_cast<const ui::CenterSlider*>(widget) != nullptr ||
                                 qobject_cast<const QListWidget*>(widget) != nullptr;
            if (!control || widget->isHidden()) continue;
            ++controls;
            EXPECT_TRUE(!widget->accessibleName().isEmpty() ||
                        (button != nullptr && !button->text().isEmpty()))
                << widget->objectName().toStdString();
            EXPECT_NE(widget->focusPolicy() & Qt::TabFocus, 0) << widget->objectName().toStdString();
        }
    }
    EXPECT_GT(controls, 25);
}

}  // namespace
}  // namespace kickstand::test
