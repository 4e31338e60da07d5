#pragma once

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <vector>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/kick_panel.h"
#include "ui/thunderbots/kick_pulses_view.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::test {

/// A test of the kick panels, on robot 3 of six simulated ones, its capacitor full.
class KickBench : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.find<QDockWidget>(QStringLiteral("kick"))->raise();
        rig.find<QDockWidget>(QStringLiteral("kicks"))->raise();
        ASSERT_TRUE(waitUntil([this] { return panel()->isVisible(); }));
    }

    ui::KickPanel* panel() { return rig.find<ui::KickPanel>(QStringLiteral("kickPanel")); }
    ui::KickPulsesView* view() { return rig.find<ui::KickPulsesView>(QStringLiteral("kickPulses")); }
    QPushButton* button(const char* name) { return panel()->findChild<QPushButton*>(QLatin1String(name)); }
    QString line(const char* name) { return rig.find<QLabel>(QLatin1String(name))->text(); }
    ui::SignedSpinBox* field(const char* name) { return rig.find<ui::SignedSpinBox>(QLatin1String(name)); }

    /// Clicks a button of this panel: the drive panel has some of the same name.
    void press(const char* name) {
        ASSERT_TRUE(waitUntil([this, name] { return button(name)->isEnabled(); }))
            << name << ": " << button(name)->toolTip().toStdString();
        QTest::mouseClick(button(name), Qt::LeftButton);
    }
    void type(const char* name, const QString& number) {
        ui::SignedSpinBox* box = field(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, number);
        QTest::keyClick(box, Qt::Key_Return);
    }
    /// Chooses the robot and arms its high voltage.
    void arm(int robot = 3) {
        rig.clickRobot(robot);
        press("kickArm");
        ASSERT_TRUE(rig.waitForSnapshot([robot](const thunderbots::Snapshot& snapshot) {
            return snapshot.intents[static_cast<std::size_t>(robot)].highVoltageArmed;
        }));
    }
    void armAndCharge(int robot = 3) {
        rig.simulate("capacitor", robot, 219);
        arm(robot);
        press("kickCharger");
        ASSERT_TRUE(rig.waitForSnapshot([robot](const thunderbots::Snapshot& snapshot) {
            return snapshot.robots[static_cast<std::size_t>(robot)].readings.charged;
        }));
    }
    /// Waits for the first kick on the wire and gives its bytes.
    std::vector<std::uint8_t> kickOnWire() {
        if (!waitUntil([this] { return !rig.wire().kickBytes().empty(); })) return {};
        return rig.wire().kickBytes().front();
    }
    /// Answers a dialog that asks for a line.
    void answer(const QString& text) {
        QInputDialog* dialog = nullptr;
        ASSERT_TRUE(waitUntil([&] {
            dialog = rig.window().findChild<QInputDialog*>(QStringLiteral("askLine"));
            return dialog != nullptr && dialog->isVisible();
        }));
        dialog->setTextValue(text);
        dialog->accept();
        // It deletes itself: the next one is another.
        ASSERT_TRUE(waitUntil(
            [this] { return rig.window().findChild<QInputDialog*>(QStringLiteral("askLine")) == nullptr; }));
    }
};

}  // namespace kickstand::test
