// Experiment data: from the robot's messages to the table, the plot and the file.

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QTableView>
#include <QTemporaryDir>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/experiment_bytes.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

class ExperimentTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.bench().goTo(QStringLiteral("experiment"));
    }
    bool receive(int robot) {
        rig.simulate("experiment", robot, 1);
        return rig.waitForSnapshot([robot](const Snapshot& snapshot) {
            return snapshot.robots[static_cast<std::size_t>(robot)].experiment.known.all();
        });
    }
    QAbstractItemModel* bytes() { return rig.find<QTableView>(QStringLiteral("experimentBytes"))->model(); }
    QString state() { return rig.find<QLabel>(QStringLiteral("experimentState"))->text(); }
};

TEST_F(ExperimentTest, AnEmptyPanelSaysWhy) {
    EXPECT_TRUE(state().contains(QStringLiteral("Nothing has arrived from robot 0")));
    EXPECT_FALSE(rig.find<QAbstractButton>(QStringLiteral("experimentSave"))->isEnabled());
    EXPECT_FALSE(rig.find<QAbstractButton>(QStringLiteral("experimentClear"))->isEnabled());
}

TEST_F(ExperimentTest, WhatArrivesIsShownByteByByteForTheChosenRobot) {
    ASSERT_TRUE(receive(2));
    rig.clickRobot(2);
    const auto& data = rig.snapshot()->robots[2].experiment.data;
    for (int offset = 0; offset < 256; ++offset) {
        const QString shown = bytes()->index(offset / 16, offset % 16).data().toString();
        ASSERT_EQ(shown.toInt(nullptr, 16), data[static_cast<std::size_t>(offset)]) << offset;
    }
    EXPECT_TRUE(state().startsWith(QStringLiteral("256 of 256 bytes")));
    auto* robots = rig.find<QComboBox>(QStringLiteral("experimentRobot"));
    EXPECT_TRUE(robots->itemText(2).contains(QStringLiteral("256")));
    robots->setCurrentIndex(3);
    EXPECT_TRUE(state().contains(QStringLiteral("Nothing has arrived from robot 3")));
}

TEST_F(ExperimentTest, AllBytesAreSeenAtOnceInTheSmallestWindow) {
    rig.window().resize(1280, 800);
    auto* table = rig.find<QTableView>(QStringLiteral("experimentBytes"));
    EXPECT_TRUE(waitUntil([table] {
        const QRect last = table->visualRect(table->model()->index(15, 15));
        return !last.isEmpty() && table->viewport()->rect().contains(last);
    }));
}

TEST_F(ExperimentTest, ClearingForgetsThisRobotAlone) {
    ASSERT_TRUE(receive(1));
    ASSERT_TRUE(receive(2));
    rig.clickRobot(2);
    rig.click(QStringLiteral("experimentClear"));
    ASSERT_TRUE(rig.waitForSnapshot(
        [](const Snapshot& snapshot) { return snapshot.robots[2].experiment.known.none(); }));
    EXPECT_TRUE(rig.snapshot()->robots[1].experiment.known.all());
    EXPECT_TRUE(waitUntil([this] { return state().contains(QStringLiteral("Nothing has arrived")); }));
    EXPECT_EQ(rig.snapshot()->robots[2].experiment.messages, 0U);
}

TEST_F(ExperimentTest, SavedAndCopiedAsCsv) {
    ASSERT_TRUE(receive(0));
    rig.clickRobot(0);
    rig.click(QStringLiteral("experimentCopy"));
    const QByteArray expected = ui::experimentCsv(rig.snapshot()->robots[0].experiment);
    EXPECT_EQ(QApplication::clipboard()->text().toUtf8(), expected);
    const QTemporaryDir folder;
    rig.click(QStringLiteral("experimentSave"));
    auto* dialog = rig.find<QFileDialog>(QStringLiteral("saveDialog"));
    EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog));
    dialog->setDirectory(folder.path());
    dialog->selectFile(QStringLiteral("data.csv"));
    static_cast<QDialog*>(dialog)->accept();
    QFile file(folder.filePath(QStringLiteral("data.csv")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), expected);
}

ExperimentBuffer partly() {
    ExperimentBuffer buffer;
    for (std::size_t offset = 32; offset < 96; ++offset) {
        buffer.known.set(offset);
        buffer.data[offset] = static_cast<std::uint8_t>(offset);
    }
    buffer.messages = 2;
    return buffer;
}

TEST(ExperimentBytes, GapsAreMarkedAndNamed) {
    EXPECT_EQ(ui::experimentText(partly()),
              QStringLiteral("64 of 256 bytes, messages: 2; missing: 0\u201331, 96\u2013255"));
    ui::ExperimentBytes model;
    model.setBuffer(partly());
    EXPECT_FALSE(model.index(1, 15).data(ui::ExperimentBytes::kKnownRole).toBool());
    EXPECT_EQ(model.index(1, 15).data().toString(), QStringLiteral("\u00b7\u00b7"));
    EXPECT_EQ(model.index(2, 1).data().toString(), QStringLiteral("21"));
    EXPECT_EQ(model.index(2, 1).data(Qt::ToolTipRole).toString(), QStringLiteral("Offset 33: 33"));
}

TEST(ExperimentBytes, ABytesThatHasNotArrivedHasNoValueInTheFile) {
    const QList<QByteArray> lines = ui::experimentCsv(partly()).split('\n');
    ASSERT_EQ(lines.size(), 1 + 256 + 1);
    EXPECT_EQ(lines[0], "offset,value");
    EXPECT_EQ(lines[1 + 31], "31,");
    EXPECT_EQ(lines[1 + 32], "32,32");
    EXPECT_EQ(lines[1 + 95], "95,95");
    EXPECT_EQ(lines[1 + 96], "96,");
}

}  // namespace
}  // namespace kickstand::test
