// The firmware wizard, page by page, as a person uses it: to the bytes on the wire and back.

#include "ui/thunderbots/flash_panel.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/bench_rig.h"
#include "ui/shell/panel_dock.h"
#include "ui/thunderbots/flash_files_page.h"
#include "ui/widgets/state_label.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

constexpr int kRobot = 2;

class FlashPanelTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.bench().goTo(QStringLiteral("firmware"));
        rig.clickRobot(kRobot);
        ASSERT_TRUE(waitUntil([this] { return panel()->isVisible(); }));
    }
    ui::FlashPanel* panel() { return find<ui::FlashPanel>("flashPanel"); }
    template <class Widget>
    Widget* find(const char* name) {
        return rig.find<Widget>(QString::fromLatin1(name));
    }
    QAbstractButton* button(const char* name) { return find<QAbstractButton>(name); }
    QString text(const char* name) { return find<QLabel>(name)->text(); }
    QString state(const char* name) { return find<ui::StateLabel>(name)->text(); }
    QString page() { return find<QWidget>("flashSteps")->accessibleName().section(QStringLiteral(": "), 1); }
    bool waitForPage(const char* name) {
        return waitUntil([this, name] { return page() == QLatin1String(name); });
    }
    bool press(const char* name) {
        const bool usable =
            waitUntil([this, name] { return button(name)->isEnabled() && button(name)->isVisible(); });
        if (usable) button(name)->click();
        return usable;
    }
    bool held(const char* part) {
        return waitUntil([this, part] {
            return !button("flashNext")->isEnabled() && text("flashReason").contains(QLatin1String(part));
        });
    }
    bool next(const char* toPage) { return press("flashNext") && waitForPage(toPage); }
    static QString image(const char* name) {
        return QStringLiteral(KICKSTAND_SOURCE_DIR "/tests/data/images/%1").arg(QLatin1String(name));
    }
    /// Chooses files in the dialog.
    void choose(const QStringList& paths, const char* with = "flashChoose") {
        ASSERT_TRUE(press(with));
        auto* dialog = rig.window().findChild<QFileDialog*>(QStringLiteral("openFilesDialog"));
        ASSERT_NE(dialog, nullptr);
        EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog))
            << "STOP keys have to reach the program";
        emit dialog->filesSelected(paths);
        dialog->close();
        ASSERT_TRUE(waitUntil([this] {
            return rig.window().findChild<QFileDialog*>(QStringLiteral("openFilesDialog")) == nullptr;
        }));
    }
    bool shows(const char* file, const char* name) {
        return waitUntil([this, file, name] {
            return find<QLabel>(file)->isVisible() && text(file) == QLatin1String(name);
        });
    }
    /// Gets as far as the review, with these files.
    void review(const QStringList& paths) {
        ASSERT_TRUE(next("Files"));
        choose(paths);
        ASSERT_TRUE(next("Review"));
    }
    /// Begins an upload of the FPGA's file to the robot.
    void begin() {
        review({image("good/bitstream.bin")});
        rig.wire().clear();
        ASSERT_TRUE(next("Progress"));
    }
    /// How many requests of a kind the robot was sent.
    std::size_t sent(wire::FirmwareOp op, int robot = kRobot) {
        std::size_t count = 0;
        for (const auto& message : rig.wire().firmware(robot))
            count += !message.empty() && message[0] == static_cast<std::uint8_t>(op) ? 1 : 0;
        return count;
    }
    bool waitForStage(const char* part) {
        return waitUntil([this, part] { return state("flashStage2").contains(QLatin1String(part)); });
    }
    QString saved(const char* with) {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("log.txt"));
        if (!press(with)) return {};
        auto* dialog = rig.window().findChild<QFileDialog*>(QStringLiteral("saveDialog"));
        if (dialog == nullptr) return {};
        emit dialog->fileSelected(path);
        dialog->close();
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }
};

TEST_F(FlashPanelTest, AnUploadFromTheTileToTheLog) {
    EXPECT_TRUE(find<QCheckBox>("flashRobot2")->isChecked()) << "taken over from the tiles";
    review({image("good/bitstream.bin")});
    EXPECT_TRUE(held("signatures")) << "nothing begins before the robot has told what it has";
    ASSERT_TRUE(waitUntil([this] { return text("flashSignature2").contains(QStringLiteral("flash: has")); }));
    EXPECT_EQ(sent(wire::FirmwareOp::ReadSignatures), 1U);
    EXPECT_EQ(button("flashNext")->text(), QStringLiteral("Start upload"));
    EXPECT_EQ(sent(wire::FirmwareOp::EraseChip), 0U);
    ASSERT_TRUE(next("Progress"));
    ASSERT_TRUE(waitForStage("erasing"));
    EXPECT_FALSE(button("flashNext")->isEnabled()) << "a running upload is not passed";
    EXPECT_TRUE(panel()->note().contains(QStringLiteral("0 of 1 done")));
    // Hidden, it goes on.
    auto* dock = rig.find<ui::PanelDock>(QStringLiteral("firmware"));
    dock->close();
    ASSERT_TRUE(waitUntil([this] { return sent(wire::FirmwareOp::ProgramPage) == 1; }));
    EXPECT_FALSE(rig.client().isStopped());
    dock->show();
    dock->raise();
    ASSERT_TRUE(waitForPage("Result"));
    EXPECT_TRUE(text("flashSentence2").contains(QStringLiteral("Robot 2 has its new firmware")));
    EXPECT_EQ(sent(wire::FirmwareOp::EraseChip), 1U);
    EXPECT_EQ(sent(wire::FirmwareOp::Reboot), 1U);
    EXPECT_FALSE(button("flashAgain")->isVisible());
    const QString log = saved("flashLog2");
    EXPECT_TRUE(log.contains(QStringLiteral("erased in"))) << log.toStdString();
    EXPECT_TRUE(log.contains(QStringLiteral("Robot 2 has its new firmware")));
    // The next time it is there already.
    ASSERT_TRUE(next("Robots"));
    ASSERT_TRUE(next("Files"));
    EXPECT_TRUE(shows("flashFile0", "bitstream.bin")) << "the files stay";
    ASSERT_TRUE(next("Review"));
    EXPECT_TRUE(held("has it already"));
    EXPECT_TRUE(button("flashLeaveOut2")->isVisible());
    EXPECT_TRUE(button("flashLeaveOut2")->isChecked());
    button("flashLeaveOut2")->click();
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }));
}

TEST_F(FlashPanelTest, StopPausesResumeGoesOnAndCancelEnds) {
    rig.clickRobot(4, Qt::ControlModifier);
    begin();
    ASSERT_TRUE(waitForStage("erasing"));
    EXPECT_FALSE(button("flashResume")->isVisible());
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(waitForStage("paused"));
    EXPECT_TRUE(text("flashPaused").contains(QStringLiteral("Re-arm, then resume")));
    EXPECT_FALSE(button("flashResume")->isEnabled()) << "not before it is re-armed";
    EXPECT_TRUE(panel()->note().contains(QStringLiteral("paused by STOP")));
    ASSERT_TRUE(rig.rearm());
    ASSERT_TRUE(press("flashResume"));
    ASSERT_TRUE(waitUntil([this] { return !state("flashStage2").contains(QStringLiteral("paused")); }));
    EXPECT_TRUE(waitUntil([this] { return !button("flashResume")->isVisible(); }));
    ASSERT_TRUE(press("flashCancel2"));
    ASSERT_TRUE(waitForStage("cancelled"));
    EXPECT_EQ(page(), QStringLiteral("Progress")) << "the other one goes on";
    EXPECT_FALSE(button("flashCancel2")->isVisible());
    ASSERT_TRUE(press("flashCancelAll"));
    ASSERT_TRUE(waitForPage("Result"));
    EXPECT_TRUE(text("flashSentence4").contains(QStringLiteral("no data"))) << "how it is left";
    EXPECT_EQ(sent(wire::FirmwareOp::Reboot), 0U);
    ASSERT_TRUE(press("flashAgain"));
    EXPECT_EQ(page(), QStringLiteral("Robots"));
    EXPECT_TRUE(find<QCheckBox>("flashRobot2")->isChecked());
    EXPECT_TRUE(find<QCheckBox>("flashRobot4")->isChecked());
    EXPECT_FALSE(find<QCheckBox>("flashRobot0")->isChecked());
}

TEST_F(FlashPanelTest, AnUnpluggedDongleIsAFailureThatIsToldAndAClosedLinkACut) {
    begin();
    ASSERT_TRUE(waitForStage("erasing"));
    rig.simulate("plugged", -1, 0);
    ASSERT_TRUE(waitForPage("Result"));
    EXPECT_TRUE(state("flashOutcome2").contains(QStringLiteral("failed")));
    EXPECT_TRUE(text("flashSentence2").contains(QStringLiteral("no data")));
    ASSERT_TRUE(press("flashAgain"));
    EXPECT_TRUE(held("The link does not run"));
    rig.simulate("plugged", -1, 1);
    ASSERT_TRUE(held("stopped"));
    ASSERT_TRUE(rig.rearm());
    ASSERT_TRUE(next("Files"));
    ASSERT_TRUE(next("Review"));
    ASSERT_TRUE(next("Progress"));
    ASSERT_TRUE(waitUntil([this] { return state("flashStage2") != QStringLiteral("beginning"); }));
    rig.bench().disconnectAll();
    ASSERT_TRUE(waitUntil([this] { return rig.bench().session() == nullptr; }));
    ASSERT_TRUE(rig.connectTo());
    rig.bench().goTo(QStringLiteral("firmware"));
    ASSERT_TRUE(waitForPage("Result"));
    EXPECT_TRUE(state("flashOutcome2").contains(QStringLiteral("cut off")));
    EXPECT_TRUE(text("flashSentence2").contains(QStringLiteral("The connection was closed")));
    ASSERT_TRUE(next("Robots"));
}

TEST_F(FlashPanelTest, WhatARobotIsUpToHoldsThePageUntilItsRemedy) {
    rig.typeWheel(1, QStringLiteral("30"));
    ASSERT_TRUE(held("Robot 2: its wheels run"));
    rig.wire().clear();
    EXPECT_EQ(button("flashRemedy2")->text(), QStringLiteral("Brake"));
    ASSERT_TRUE(press("flashRemedy2"));
    ASSERT_TRUE(rig.waitForBlock(kRobot, [](const wire::DriveBlock& block) { return !block.run; }));
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }));
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(held("Everything is stopped"));
    ASSERT_TRUE(rig.rearm());
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }));
    rig.clickRobot(9);
    ASSERT_TRUE(held("Robot 9: not heard"));
    button("flashRobot9")->click();
    ASSERT_TRUE(held("Tick the robots"));
    ASSERT_TRUE(press("flashEveryone"));
    EXPECT_TRUE(waitUntil([this] { return panel()->note() == QStringLiteral("robots 0\u20135"); }));
}

TEST_F(FlashPanelTest, ALowBatteryIsAdvisedAgainstAndCanBeAccepted) {
    EXPECT_FALSE(button("flashLowBattery")->isVisible());
    rig.simulate("battery", kRobot, 13.6);
    ASSERT_TRUE(held("too low"));
    EXPECT_EQ(find<ui::StateLabel>("flashState2")->tone(), ui::Tone::Warning);
    ASSERT_TRUE(press("flashLowBattery"));
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }));
    EXPECT_TRUE(
        waitUntil([this] { return state("flashState2").contains(QStringLiteral("advised against")); }));
    EXPECT_EQ(find<ui::StateLabel>("flashState2")->tone(), ui::Tone::Warning);
}

TEST_F(FlashPanelTest, ALiveCapacitorIsDischargedFromThePageAndTheRobotDisarmed) {
    rig.simulate("capacitor", kRobot, 100);
    ASSERT_TRUE(held("on its capacitor"));
    EXPECT_EQ(find<ui::StateLabel>("flashState2")->tone(), ui::Tone::Danger);
    ASSERT_TRUE(press("flashRemedy2"));
    ASSERT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }))
        << text("flashReason").toStdString();
    EXPECT_FALSE(rig.snapshot()->intents[kRobot].highVoltageArmed);
    EXPECT_LT(rig.snapshot()->robots[kRobot].readings.capacitor_V, 50);
}

TEST_F(FlashPanelTest, FilesThatCannotBeUsedAreRefusedWithWhatIsWrongInThem) {
    ASSERT_TRUE(next("Files"));
    EXPECT_TRUE(held("Choose a file"));
    const std::pair<const char*, const char*> cases[] = {
        {"malformed/bad-checksum.hex", "Line 2 is damaged"},
        {"malformed/overlap.hex", "Line 3 has data for address 0x00003"},
        {"malformed/past-flash.hex", "0x1fffff"},
        {"malformed/junk.hex", "Line 2 is no Intel HEX record"},
        {"malformed/missing-end.hex", "cut off"},
        {"malformed/cut-off.bit", "bytes where its header promises"},
        {"malformed/empty.bin", "no data"},
        {"malformed/not-there.hex", "cannot be read"},
    };
    for (const auto& [name, words] : cases) {
        choose({image(name)});
        ASSERT_TRUE(waitUntil([this] { return find<QLabel>("flashProblem0")->isVisible(); })) << name;
        EXPECT_TRUE(text("flashProblem0").contains(QLatin1String(words)))
            << name << ": " << text("flashProblem0").toStdString();
        EXPECT_TRUE(held("cannot be used")) << name;
        ASSERT_TRUE(press("flashRemove0"));
        ASSERT_TRUE(held("Choose a file"));
    }
}

TEST_F(FlashPanelTest, TheTargetIsGuessedAndTheOtherOneRefused) {
    ASSERT_TRUE(next("Files"));
    choose({image("good/bitstream.bit")});
    ASSERT_TRUE(shows("flashFile0", "bitstream.bit"));
    auto* target = find<QComboBox>("flashTarget0");
    EXPECT_EQ(target->currentText(), QStringLiteral("FPGA"));
    EXPECT_TRUE(text("flashWhy0").contains(QStringLiteral("header of a Xilinx")));
    EXPECT_TRUE(text("flashFacts0").contains(QStringLiteral("part ")));
    EXPECT_TRUE(text("flashFacts0").contains(QStringLiteral("signature of the flash 0x")));
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }));
    target->setFocus();
    QTest::keyClick(target, Qt::Key_Up);
    ASSERT_TRUE(held("bitstream.bit cannot be used"));
    EXPECT_TRUE(text("flashProblem0").contains(QStringLiteral("This is a bitstream")));
    QTest::keyClick(target, Qt::Key_Down);
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }));
}

TEST_F(FlashPanelTest, FirmwareAloneSaysWhatItCostsAndTheOtherFileIsAdded) {
    ASSERT_TRUE(next("Files"));
    choose({image("good/configuration.hex")});
    ASSERT_TRUE(shows("flashFile0", "configuration.hex"));
    EXPECT_TRUE(text("flashFacts0").contains(QStringLiteral("is left out")))
        << text("flashFacts0").toStdString();
    EXPECT_TRUE(text("flashOrder").contains(QStringLiteral("will not drive")));
    choose({image("good/bitstream.bin")}, "flashAddFpga");
    ASSERT_TRUE(shows("flashFile1", "bitstream.bin"));
    EXPECT_TRUE(text("flashOrder").contains(QStringLiteral("sent first")));
    EXPECT_FALSE(button("flashAddFpga")->isVisible());
    choose({image("good/gaps.hex")});
    ASSERT_TRUE(waitUntil([this] { return text("flashFilesNotice").contains(QStringLiteral("not taken")); }));
    find<QComboBox>("flashTarget1")->setFocus();
    ASSERT_TRUE(press("flashRemove1"));
    EXPECT_TRUE(waitUntil([this] { return !find<QLabel>("flashFile1")->isVisible(); }));
}

TEST_F(FlashPanelTest, FilesAreDroppedOnThePage) {
    ASSERT_TRUE(next("Files"));
    auto* target = rig.window().findChild<ui::FlashFilesPage*>();
    ASSERT_NE(target, nullptr);
    QMimeData data;
    data.setUrls(
        {QUrl::fromLocalFile(image("good/firmware.hex")), QUrl::fromLocalFile(image("good/bitstream.bin"))});
    QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(target, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(target, &drop);
    EXPECT_TRUE(waitUntil([this] {
        return find<QLabel>("flashFile0")->isVisible() && find<QLabel>("flashFile1")->isVisible();
    }));
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }));
}

TEST_F(FlashPanelTest, TheReviewHoldsForARobotThatIsLostAndReadsItAgain) {
    review({image("good/bitstream.bin")});
    rig.simulate("dead", kRobot, 1);
    ASSERT_TRUE(held("Robot 2: not heard"));
    rig.simulate("dead", kRobot, 0);
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.robots[kRobot].live; }));
    if (button("flashReadAgain")->isVisible()) button("flashReadAgain")->click();
    EXPECT_TRUE(waitUntil([this] { return button("flashNext")->isEnabled(); }))
        << text("flashReason").toStdString();
    // The dialog has taken the window's place.
    QApplication::setActiveWindow(&rig.window());
    button("flashNext")->setFocus();
    rig.press(Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(page(), QStringLiteral("Files"));
}

}  // namespace
}  // namespace kickstand::test
