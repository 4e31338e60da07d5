// The Parameters panel: every control to the bytes on the wire, and what the robot has back on the screen.

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/parameters_panel.h"
#include "ui/widgets/state_label.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using Message = std::vector<std::uint8_t>;

constexpr int kRobot = 2;

class ParametersTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.bench().goTo(QStringLiteral("parameters"));
        rig.clickRobot(kRobot);
    }
    template <class Widget>
    Widget* find(const char* name) {
        return rig.find<Widget>(QString::fromLatin1(name));
    }
    QAbstractButton* button(const char* name) { return find<QAbstractButton>(name); }
    QSpinBox* number(const char* name) { return find<QSpinBox>(name); }
    bool usable(const char* name) {
        return waitUntil([this, name] { return button(name)->isEnabled(); });
    }
    bool press(const char* name) {
        if (!usable(name)) return false;
        rig.click(QString::fromLatin1(name));
        return true;
    }
    /// Reads the robot, and waits until nothing more is asked of it.
    bool read() {
        return press("parameterRead") && waitUntil([this] { return known().signatures.has_value(); }) &&
               usable("parameterRead");
    }
    const ParameterState& known(int robot = kRobot) {
        return rig.snapshot()->parameters[static_cast<std::size_t>(robot)];
    }
    QString state() { return find<ui::StateLabel>("parameterState")->text(); }
    bool waitForState(const char* text) {
        return waitUntil([this, text] { return state().contains(QLatin1String(text)); });
    }
    QString text(const char* name) { return find<QLabel>(name)->text(); }
    void type(const char* name, const char* digits) {
        QSpinBox* spin = number(name);
        spin->setFocus();
        spin->selectAll();
        QTest::keyClicks(spin, QString::fromLatin1(digits));
    }
    void choose(const char* name, int value) {
        auto* list = find<QComboBox>(name);
        list->setFocus();
        const int index = list->findData(value);
        ASSERT_GE(index, 0);
        while (list->currentIndex() != index)
            QTest::keyClick(list, list->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
    }
    /// The last message to the robot's firmware pipe that began so.
    Message lastRequest(std::uint8_t opcode) {
        Message found;
        for (const Message& message : rig.wire().firmware(kRobot)) {
            if (!message.empty() && message[0] == opcode) found = message;
        }
        return found;
    }
    QMessageBox* question() {
        return rig.window().findChild<QMessageBox*>(QStringLiteral("parameterQuestion"));
    }
    static void accept(QFileDialog* dialog, const QString& path) {
        ASSERT_NE(dialog, nullptr);
        emit dialog->fileSelected(path);
        dialog->close();
    }
    QTreeWidget* history() { return find<QTreeWidget>("parameterHistory"); }
};

TEST_F(ParametersTest, BeforeReadingNothingIsClaimed) {
    EXPECT_EQ(text("robot_channel0"), QStringLiteral("\u2013"));
    EXPECT_TRUE(waitForState("Not read yet"));
    EXPECT_FALSE(button("parameterApply")->isEnabled());
    EXPECT_FALSE(button("parameterCommit")->isEnabled());
    EXPECT_TRUE(text("parameterNotice").contains(QStringLiteral("Read the robot's parameters first")));
}

TEST_F(ParametersTest, ReadingShowsWhatTheRobotHasAndKeepsIt) {
    ASSERT_TRUE(read());
    EXPECT_EQ(lastRequest(4), Message{4});
    EXPECT_EQ(lastRequest(9), Message{9});
    EXPECT_EQ(text("robot_channel0"), QStringLiteral("0x0e (14)"));
    EXPECT_EQ(text("robot_robot_number"), QStringLiteral("2"));
    EXPECT_EQ(text("robot_flash_contents"), QStringLiteral("FPGA bitstream"));
    EXPECT_EQ(number("draft_robot_number")->value(), 2);
    EXPECT_TRUE(waitForState("As read from the robot"));
    ASSERT_TRUE(waitUntil([this] { return history()->topLevelItemCount() == 1; }));
    ASSERT_TRUE(rig.ledger().flush(std::chrono::seconds(20)));
    EXPECT_TRUE(rig.ledger().view().records->front().flashSignature.has_value());
}

TEST_F(ParametersTest, EveryFieldGoesToTheWireAsItIsDrafted) {
    ASSERT_TRUE(read());
    const Message before = lastRequest(4);
    choose("draft_channel0", 11);
    choose("draft_channel1", 26);
    choose("draft_flash_contents", 0xFF);
    type("draft_robot_number", "9");
    type("draft_dribbler_duty", "200");
    EXPECT_EQ(number("draft_dribbler_duty_percent")->value(), 78);
    EXPECT_EQ(text("mark_channel0"), QStringLiteral("\u25b2"));
    EXPECT_EQ(button("parameterApply")->text(), QStringLiteral("Apply 5 changes"));
    ASSERT_TRUE(press("parameterApply"));
    ASSERT_NE(question(), nullptr);
    rig.click(QStringLiteral("parameterYes"));
    ASSERT_TRUE(waitUntil([this] { return !lastRequest(5).empty(); }));
    EXPECT_EQ(lastRequest(5), (Message{5, 0xFF, 11, 26, 9, 200, 0}));
    ASSERT_TRUE(waitForState("Applied: lives until the robot reboots"));
    EXPECT_EQ(text("robot_dribbler_duty"), QStringLiteral("200 (78 %)"));
    EXPECT_FALSE(button("parameterApply")->isEnabled()) << "nothing is left to apply";
}

TEST_F(ParametersTest, OnlyWhatIsTickedIsApplied) {
    ASSERT_TRUE(read());
    type("draft_dribbler_duty", "33");
    type("draft_robot_number", "9");
    find<QCheckBox>("apply_robot_number")->setChecked(false);
    ASSERT_TRUE(press("parameterApply"));
    EXPECT_EQ(question(), nullptr) << "a duty loses nobody";
    ASSERT_TRUE(waitUntil([this] { return !lastRequest(5).empty(); }));
    EXPECT_EQ(lastRequest(5)[4], kRobot);
    EXPECT_EQ(lastRequest(5)[5], 33);
    ASSERT_TRUE(waitForState("Applied"));
    EXPECT_EQ(number("draft_robot_number")->value(), 9) << "the rest of the draft stays";
}

TEST_F(ParametersTest, ADutyCanBeTypedAsAPercentage) {
    ASSERT_TRUE(read());
    type("draft_dribbler_duty_percent", "50");
    EXPECT_EQ(number("draft_dribbler_duty")->value(), 128);
}

TEST_F(ParametersTest, UndoAndRedoWorkFromInsideAField) {
    ASSERT_TRUE(read());
    const int before = number("draft_dribbler_duty")->value();
    type("draft_dribbler_duty", "200");
    type("draft_robot_number", "9");
    QTest::keyClick(number("draft_robot_number"), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(number("draft_robot_number")->value(), kRobot);
    EXPECT_EQ(number("draft_dribbler_duty")->value(), 200);
    QTest::keyClick(number("draft_robot_number"), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(number("draft_dribbler_duty")->value(), before);
    EXPECT_FALSE(button("parameterUndo")->isEnabled());
    QTest::keyClick(number("draft_robot_number"), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(number("draft_dribbler_duty")->value(), 200);
    ASSERT_TRUE(press("parameterRedo"));
    EXPECT_EQ(number("draft_robot_number")->value(), 9);
    ASSERT_TRUE(press("parameterReset"));
    EXPECT_EQ(number("draft_robot_number")->value(), kRobot);
    ASSERT_TRUE(press("parameterUndo"));
    EXPECT_EQ(number("draft_robot_number")->value(), 9) << "a reset is a step too";
}

TEST_F(ParametersTest, ANumberThatIsTakenIsAskedAboutFirst) {
    ASSERT_TRUE(read());
    type("draft_robot_number", "4");
    ASSERT_TRUE(press("parameterApply"));
    ASSERT_NE(question(), nullptr);
    EXPECT_TRUE(question()->informativeText().contains(QStringLiteral("so does the robot 4")))
        << question()->informativeText().toStdString();
    EXPECT_TRUE(question()->informativeText().contains(QStringLiteral("Once this is committed")));
    rig.click(QStringLiteral("parameterNo"));
    ASSERT_TRUE(waitUntil([this] { return question() == nullptr; }));
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(lastRequest(5).empty());
}

TEST_F(ParametersTest, WhatIsCommittedIsProvenByAReboot) {
    ASSERT_TRUE(read());
    type("draft_dribbler_duty", "77");
    ASSERT_TRUE(press("parameterApply"));
    ASSERT_TRUE(waitForState("Applied"));
    ASSERT_TRUE(press("parameterCommit"));
    ASSERT_TRUE(waitForState("Committed, unproven until the next reboot"));
    EXPECT_EQ(lastRequest(7), Message{7});
    ASSERT_TRUE(press("parameterReboot"));
    ASSERT_TRUE(waitUntil([this] { return known().standing >= ParameterStanding::Rebooted; }));
    EXPECT_EQ(lastRequest(8), Message{8});
    ASSERT_TRUE(waitForState("Proven: read after a reboot"));
    EXPECT_EQ(known().robot->dribblerDuty, 77);
    EXPECT_FALSE(rig.client().isStopped());
}

TEST_F(ParametersTest, ARebootThatLosesWhatWasAppliedIsAskedAbout) {
    ASSERT_TRUE(read());
    type("draft_dribbler_duty", "77");
    ASSERT_TRUE(press("parameterApply"));
    ASSERT_TRUE(waitForState("Applied"));
    ASSERT_TRUE(press("parameterReboot"));
    ASSERT_NE(question(), nullptr);
    EXPECT_TRUE(question()->informativeText().contains(QStringLiteral("not committed is lost")));
    rig.click(QStringLiteral("parameterYes"));
    ASSERT_TRUE(waitUntil([this] { return known().standing == ParameterStanding::Unread; }));
}

TEST_F(ParametersTest, AFileStandsBesideTheDraftAndIsTakenOver) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("quick.json"));
    ASSERT_TRUE(read());
    type("draft_dribbler_duty", "210");
    rig.click(QStringLiteral("parameterSave"));
    accept(rig.window().findChild<QFileDialog*>(QStringLiteral("saveDialog")), path);
    ASSERT_TRUE(waitUntil([&path] { return QFile::exists(path); }));
    ASSERT_TRUE(press("parameterReset"));
    rig.click(QStringLiteral("parameterOpen"));
    accept(rig.window().findChild<QFileDialog*>(QStringLiteral("openDialog")), path);
    EXPECT_EQ(text("otherTitle"), QStringLiteral("quick.json"));
    EXPECT_EQ(text("other_dribbler_duty"), QStringLiteral("210 (82 %)"));
    ASSERT_TRUE(press("take_dribbler_duty"));
    EXPECT_EQ(number("draft_dribbler_duty")->value(), 210);
    ASSERT_TRUE(press("parameterUndo"));
    ASSERT_TRUE(press("parameterTakeAll"));
    EXPECT_EQ(number("draft_dribbler_duty")->value(), 210);
}

TEST_F(ParametersTest, AFileThatIsNoneIsSaid) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("song.json"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{}");
    file.close();
    ASSERT_TRUE(read());
    rig.click(QStringLiteral("parameterOpen"));
    accept(rig.window().findChild<QFileDialog*>(QStringLiteral("openDialog")), path);
    EXPECT_TRUE(text("parameterNotice").contains(QStringLiteral("no file of parameters")))
        << text("parameterNotice").toStdString();
}

TEST_F(ParametersTest, AnEarlierReadingIsComparedRestoredAndNoted) {
    ASSERT_TRUE(read());
    const int before = number("draft_dribbler_duty")->value();
    type("draft_dribbler_duty", "77");
    ASSERT_TRUE(press("parameterApply"));
    ASSERT_TRUE(waitForState("Applied"));
    ASSERT_TRUE(waitUntil([this] { return history()->topLevelItemCount() == 2; }));
    rig.click(QStringLiteral("parameterHistoryPage"));
    EXPECT_FALSE(button("historyRestore")->isEnabled());
    history()->setCurrentItem(history()->topLevelItem(1));
    ASSERT_TRUE(press("historyCompare"));
    EXPECT_TRUE(text("other_dribbler_duty").startsWith(QString::number(before)));
    EXPECT_EQ(number("draft_dribbler_duty")->value(), 77);
    rig.click(QStringLiteral("parameterHistoryPage"));
    ASSERT_TRUE(press("historyRestore"));
    EXPECT_EQ(number("draft_dribbler_duty")->value(), before);
    rig.click(QStringLiteral("parameterHistoryPage"));
    ASSERT_TRUE(press("historyNote"));
    auto* dialog = rig.window().findChild<QInputDialog*>(QStringLiteral("askLine"));
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue(QStringLiteral("the red one"));
    dialog->accept();
    ASSERT_TRUE(
        waitUntil([this] { return history()->topLevelItem(1)->text(4) == QStringLiteral("the red one"); }));
    EXPECT_TRUE(history()->topLevelItem(1)->isSelected()) << "the list keeps its place";
}

TEST_F(ParametersTest, EachRobotHasADraftOfItsOwn) {
    ASSERT_TRUE(read());
    type("draft_dribbler_duty", "77");
    rig.clickRobot(4);
    EXPECT_NE(number("draft_dribbler_duty")->value(), 77);
    rig.clickRobot(kRobot);
    EXPECT_EQ(number("draft_dribbler_duty")->value(), 77);
}

TEST_F(ParametersTest, WithoutOneHeardRobotItSaysWhy) {
    rig.clickRobot(3, Qt::ControlModifier);
    EXPECT_TRUE(text("parameterNotice").contains(QStringLiteral("Choose one robot")));
    EXPECT_FALSE(button("parameterRead")->isEnabled());
    rig.clickRobot(9);
    EXPECT_TRUE(text("parameterNotice").contains(QStringLiteral("Robot 9 is not heard")));
}

TEST_F(ParametersTest, WhileEverythingIsStoppedNothingIsRebooted) {
    ASSERT_TRUE(read());
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(waitUntil([this] { return !button("parameterReboot")->isEnabled(); }));
    EXPECT_TRUE(text("parameterNotice").contains(QStringLiteral("re-arm")));
    EXPECT_TRUE(button("parameterRead")->isEnabled()) << "reading moves nothing";
}

TEST_F(ParametersTest, ARobotWithAChargedCapacitorIsNotRebooted) {
    rig.simulate("capacitor", kRobot, 180);
    ASSERT_TRUE(waitUntil([this] { return !button("parameterReboot")->isEnabled(); }));
    ASSERT_TRUE(read());
    EXPECT_TRUE(text("parameterNotice").contains(QStringLiteral("below 50 V")))
        << text("parameterNotice").toStdString();
}

}  // namespace
}  // namespace kickstand::test
