// The table of kicks and the sweep, to the bytes on the wire and back.

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QTableView>
#include <QTemporaryDir>

#include "tests/ui/kick_testing.h"
#include "ui/thunderbots/kick_rows.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using ui::KickRows;

class KickLogPanelTest : public KickBench {
  protected:
    QTableView* table() { return rig.find<QTableView>(QStringLiteral("kickTable")); }
    QString cell(int row, int column) { return table()->model()->index(row, column).data().toString(); }
    /// Kicks once and waits until what it did is in the table.
    void kickAndMeasure(const QString& width_us) {
        const int before = table()->model()->rowCount();
        ASSERT_TRUE(rig.waitForSnapshot(
            [](const Snapshot& snapshot) { return snapshot.robots[3].readings.charged; }));
        type("kickWidth1", width_us);
        press("kickFirst");
        ASSERT_TRUE(waitUntil([this, before] {
            return table()->model()->rowCount() == before + 1 &&
                   cell(0, KickRows::Recharge).endsWith(QStringLiteral(" s"));
        }));
    }
};

TEST_F(KickLogPanelTest, AKickFillsALineWithItsSettingsAndWhatItDid) {
    armAndCharge();
    kickAndMeasure(QStringLiteral("2400"));
    EXPECT_EQ(cell(0, KickRows::Robot), QStringLiteral("3"));
    EXPECT_EQ(cell(0, KickRows::Width1), QStringLiteral("2400 \u00b5s"));
    EXPECT_EQ(cell(0, KickRows::Width2), QStringLiteral("0 \u00b5s"));
    EXPECT_EQ(cell(0, KickRows::Cause), QStringLiteral("by hand"));
    EXPECT_TRUE(cell(0, KickRows::Before).startsWith(QStringLiteral("21")))
        << cell(0, KickRows::Before).toStdString();
    EXPECT_EQ(cell(0, KickRows::After),
              QStringLiteral("%1 V").arg(*rig.snapshot()->kicks->back().after_V, 0, 'f', 1));
}

TEST_F(KickLogPanelTest, TheNewestIsOnTopAndAHeadingSorts) {
    armAndCharge();
    kickAndMeasure(QStringLiteral("640"));
    kickAndMeasure(QStringLiteral("1920"));
    kickAndMeasure(QStringLiteral("1280"));
    EXPECT_EQ(cell(0, KickRows::Width1), QStringLiteral("1280 \u00b5s"));
    table()->sortByColumn(KickRows::Drop, Qt::DescendingOrder);
    EXPECT_EQ(cell(0, KickRows::Width1), QStringLiteral("1920 \u00b5s"));
    EXPECT_EQ(cell(2, KickRows::Width1), QStringLiteral("640 \u00b5s"));
}

TEST_F(KickLogPanelTest, NotesAreWrittenCopiedAndSaved) {
    armAndCharge();
    kickAndMeasure(QStringLiteral("640"));
    table()->model()->setData(table()->model()->index(0, KickRows::Note), QStringLiteral("wet ball"),
                              Qt::EditRole);
    QApplication::clipboard()->clear();
    rig.click(QStringLiteral("kickCopy"));
    const QString copied = QApplication::clipboard()->text();
    EXPECT_TRUE(copied.contains(QStringLiteral("\"wet ball\""))) << copied.toStdString();
    EXPECT_TRUE(copied.startsWith(QStringLiteral("time,robot,")));

    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("out.csv"));
    rig.click(QStringLiteral("kickSave"));
    QFileDialog* dialog = nullptr;
    ASSERT_TRUE(waitUntil([&] {
        dialog = rig.window().findChild<QFileDialog*>(QStringLiteral("saveDialog"));
        return dialog != nullptr && dialog->isVisible();
    }));
    EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog)) << "STOP has to get through";
    emit dialog->fileSelected(path);
    dialog->close();
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(QString::fromUtf8(file.readAll()), copied);
}

TEST_F(KickLogPanelTest, ASweepGivesItsKicksAndFillsTheTable) {
    armAndCharge();
    type("kickWidth1", QStringLiteral("2400"));
    type("kickWidth2", QStringLiteral("320"));
    type("kickOffset", QStringLiteral("64"));
    type("sweepFrom", QStringLiteral("640"));
    type("sweepTo", QStringLiteral("960"));
    type("sweepStep", QStringLiteral("320"));
    rig.wire().clear();
    rig.click(QStringLiteral("sweepStart"));
    ASSERT_TRUE(rig.waitForSnapshot(
        [](const Snapshot& snapshot) { return snapshot.sweep && !snapshot.sweep->running(); }));
    EXPECT_EQ(rig.wire().kickBytes(),
              (std::vector<std::vector<std::uint8_t>>{{0x94, 0x0c, 0x02}, {0x9e, 0x0c, 0x02}}));
    ASSERT_TRUE(waitUntil([this] { return table()->model()->rowCount() == 2; }));
    EXPECT_EQ(cell(0, KickRows::Cause), QStringLiteral("sweep"));
    ASSERT_TRUE(waitUntil([this] { return line("sweepProgress").contains(QStringLiteral("Done: 2 kicks")); }))
        << line("sweepProgress").toStdString();
}

TEST_F(KickLogPanelTest, ASweepIsStoppedByItsButton) {
    armAndCharge();
    type("sweepFrom", QStringLiteral("320"));
    type("sweepTo", QStringLiteral("4064"));
    type("sweepStep", QStringLiteral("32"));
    type("sweepPause", QStringLiteral("200"));
    rig.click(QStringLiteral("sweepStart"));
    ASSERT_TRUE(waitUntil([this] { return !rig.wire().kicks().empty(); }));
    ASSERT_TRUE(waitUntil([this] { return line("sweepProgress").contains(QStringLiteral("of 118")); }))
        << line("sweepProgress").toStdString();
    EXPECT_FALSE(button("kickFirst")->isEnabled()) << "its robot takes no other kick";
    rig.click(QStringLiteral("sweepStop"));
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) { return !snapshot.sweep->running(); }));
    EXPECT_EQ(rig.snapshot()->sweep->endedBy, Errc::Cancelled);
    ASSERT_TRUE(
        waitUntil([this] { return line("sweepProgress").contains(QStringLiteral("Stopped after")); }));
}

TEST_F(KickLogPanelTest, StopEndsASweep) {
    armAndCharge();
    type("sweepPause", QStringLiteral("200"));
    rig.click(QStringLiteral("sweepStart"));
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.intents[3].sweeping; }));
    rig.press(Qt::Key_Escape);
    ASSERT_TRUE(rig.waitForStop());
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) { return !snapshot.sweep->running(); }));
    ASSERT_TRUE(
        rig.waitForBlock(3, [](const wire::DriveBlock& block) { return block == wire::brakedBlock(); }));
}

TEST_F(KickLogPanelTest, WhyASweepCannotBeStartedIsSaid) {
    rig.clickRobot(3);
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(rig.find<QPushButton>(QStringLiteral("sweepStart"))->isEnabled());
    EXPECT_TRUE(line("sweepProgress").contains(QStringLiteral("not armed")));
    arm();
    type("kickWidth2", QStringLiteral("320"));
    type("kickOffset", QStringLiteral("-640"));
    ASSERT_TRUE(waitUntil([this] {
        return line("sweepProgress").contains(QStringLiteral("Width 2 stays 320 µs, the offset −640 µs."));
    })) << line("sweepProgress").toStdString();
    type("sweepTo", QStringLiteral("4064"));
    ASSERT_TRUE(waitUntil([this] { return line("sweepProgress").contains(QStringLiteral("4064")); }))
        << line("sweepProgress").toStdString();
    EXPECT_FALSE(rig.find<QPushButton>(QStringLiteral("sweepStart"))->isEnabled());
}

TEST_F(KickLogPanelTest, SweepSettingsAreOnTheGridAndRemembered) {
    type("sweepFrom", QStringLiteral("650"));
    EXPECT_EQ(field("sweepFrom")->value(), 640);
    EXPECT_EQ(rig.settings().value(QStringLiteral("kick/sweepFrom")).toInt(), 640);
    rig.find<QComboBox>(QStringLiteral("sweepSolenoid"))->setCurrentIndex(1);
    EXPECT_EQ(rig.settings().value(QStringLiteral("kick/sweepSolenoid")).toInt(), 1);
    type("sweepCount", QStringLiteral("3"));
    EXPECT_EQ(rig.settings().value(QStringLiteral("kick/sweepCount")).toInt(), 3);
}

}  // namespace
}  // namespace kickstand::test
