// The list of events: following the newest, copying, saving, and saying what was lost.

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>

#include "tests/ui/bench_rig.h"
#include "ui/shell/event_model.h"

namespace kickstand::test {
namespace {

class EventsTest : public BenchTest {
  protected:
    QTableView* list() { return rig.find<QTableView>(QStringLiteral("eventList")); }
    QAbstractButton* follow() { return rig.find<QAbstractButton>(QStringLiteral("eventFollow")); }
    bool happen(int times) {
        const int before = list()->model()->rowCount();
        for (int i = 0; i < times; ++i)
            rig.simulate("error", -1, 39);
        return waitUntil([this, before, times] { return list()->model()->rowCount() >= before + times; });
    }
};

TEST_F(EventsTest, TheNewestStaysInViewUntilAPersonScrollsAway) {
    ASSERT_TRUE(happen(30));
    EXPECT_TRUE(follow()->isChecked());
    EXPECT_EQ(list()->verticalScrollBar()->value(), 0);
    list()->verticalScrollBar()->setValue(100);
    EXPECT_FALSE(follow()->isChecked());
    const QString read = list()->indexAt({4, 4}).siblingAtColumn(0).data().toString();
    const int row = list()->indexAt({4, 4}).row();
    ASSERT_TRUE(happen(5));
    EXPECT_EQ(list()->indexAt({4, 4}).row(), row + 5);
    EXPECT_EQ(list()->indexAt({4, 4}).siblingAtColumn(0).data().toString(), read);
    rig.click(QStringLiteral("eventFollow"));
    EXPECT_EQ(list()->verticalScrollBar()->value(), 0);
}

TEST_F(EventsTest, CopiesWhatIsMarkedOrAll) {
    rig.simulate("battery", 2, 14.5);
    ASSERT_TRUE(waitUntil([this] {
        rig.find<QLineEdit>(QStringLiteral("eventText"))->setText(QStringLiteral("battery low: 14.5"));
        return list()->model()->rowCount() > 0;
    }));
    rig.click(QStringLiteral("eventCopy"));
    const QString all = QApplication::clipboard()->text();
    EXPECT_TRUE(all.contains(QStringLiteral("robot 2\tbattery low: 14.5 V"))) << all.toStdString();
    EXPECT_EQ(all.count(u'\n'), list()->model()->rowCount() - 1);
    rig.find<QLineEdit>(QStringLiteral("eventText"))->clear();
    list()->selectRow(0);
    rig.click(QStringLiteral("eventCopy"));
    EXPECT_EQ(QApplication::clipboard()->text().count(u'\n'), 0);
}

TEST_F(EventsTest, SavesWhatIsShown) {
    const QTemporaryDir folder;
    ASSERT_TRUE(rig.settle());
    rig.click(QStringLiteral("eventSave"));
    auto* dialog = rig.find<QFileDialog>(QStringLiteral("saveDialog"));
    dialog->setDirectory(folder.path());
    dialog->selectFile(QStringLiteral("events.csv"));
    const QByteArray expected = ui::eventCsv(*list()->model());
    static_cast<QDialog*>(dialog)->accept();
    QFile file(folder.filePath(QStringLiteral("events.csv")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray written = file.readAll();
    EXPECT_TRUE(written.startsWith("time,robot,weight,what\n"));
    EXPECT_TRUE(written.contains("connected, all robots told to brake"));
    EXPECT_EQ(written.count('\n'), 1 + list()->model()->rowCount());
    EXPECT_EQ(written, expected);
}

TEST_F(EventsTest, AFileThatCannotBeWrittenIsSaid) {
    rig.click(QStringLiteral("eventSave"));
    auto* dialog = rig.find<QFileDialog>(QStringLiteral("saveDialog"));
    emit dialog->fileSelected(QStringLiteral("/nowhere/at/all/events.csv"));
    QWidget* box = nullptr;
    ASSERT_TRUE(waitUntil([&box] {
        for (QWidget* top : QApplication::topLevelWidgets()) {
            if (top->inherits("QMessageBox") && top->isVisible()) box = top;
        }
        return box != nullptr;
    }));
    EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->text().contains(QStringLiteral("/nowhere/at/all")));
    box->close();
    dialog->close();
}

TEST(EventModel, SaysHowManyGaveWay) {
    ui::EventModel model(nullptr, 3);
    std::vector<ui::EventLine> lines(5);
    model.add(lines);
    EXPECT_EQ(model.rowCount(), 3);
    EXPECT_EQ(model.dropped(), 2U);
    model.add({ui::EventLine{}});
    EXPECT_EQ(model.dropped(), 3U);
}

TEST(EventModel, TheFileQuotesWhatWouldBreakIt) {
    ui::EventModel model;
    ui::EventLine line;
    line.text = QStringLiteral("says \"no\", twice");
    line.robot = 7;
    line.severity = Severity::Danger;
    model.add({line});
    EXPECT_TRUE(ui::eventCsv(model).endsWith(",7,danger,\"says \"\"no\"\", twice\"\n"));
}

}  // namespace
}  // namespace kickstand::test
