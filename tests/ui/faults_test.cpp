// Fault codes: both tables, searched, and reached from the event that brought a code.

#include <QComboBox>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QTranslator>

#include "core/engine/describe_fault.h"
#include "tests/ui/bench_rig.h"
#include "ui/shell/event_model.h"
#include "ui/thunderbots/faults_model.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

class FaultsTest : public BenchTest {
  protected:
    QTableView* faults() { return rig.find<QTableView>(QStringLiteral("faultList")); }
    QTableView* events() { return rig.find<QTableView>(QStringLiteral("eventList")); }
    void search(const QString& text) { rig.find<QLineEdit>(QStringLiteral("faultSearch"))->setText(text); }
    /// The row of the event that says `text`; -1 where there is none.
    int eventRow(const QString& text) {
        for (int row = 0; row < events()->model()->rowCount(); ++row) {
            if (events()->model()->index(row, ui::EventModel::Text).data().toString().contains(text))
                return row;
        }
        return -1;
    }
    /// A tab that is behind others counts as visible, and nothing of it is seen.
    bool isInFront() { return !faults()->visibleRegion().isEmpty(); }
    QString currentCode() {
        return faults()->currentIndex().siblingAtColumn(ui::FaultsModel::Code).data().toString();
    }
};

/// A language that says every fault's meaning in capitals.
class Capitals final : public QTranslator {
  public:
    QString translate(const char* context, const char* source, const char*, int) const override {
        return qstrcmp(context, "Fault") == 0 ? QString::fromUtf8(source).toUpper() : QString();
    }
    bool isEmpty() const override { return false; }
};

TEST_F(FaultsTest, WhatACodeSaysIsTranslated) {
    Capitals language;
    QCoreApplication::installTranslator(&language);
    const ui::FaultsModel model;
    const int row = model.rowOf(ui::FaultTable::Dongle, 48);
    EXPECT_EQ(model.index(row, ui::FaultsModel::Meaning).data().toString(),
              QStringLiteral("MESSAGE COULD NOT BE SENT"));
    EXPECT_EQ(faultText(wire::dongleFault(48)), QStringLiteral("ROBOT 7: MESSAGE COULD NOT BE SENT"));
    EXPECT_EQ(faultText(wire::dongleFault(200)), QStringLiteral("UNKNOWN FAULT CODE 200"));
    QCoreApplication::removeTranslator(&language);
}

TEST_F(FaultsTest, BothTablesAreThereAndCanBeToldApart) {
    EXPECT_EQ(faults()->model()->rowCount(), wire::kDongleFaultCount + wire::kRobotFaultCount);
    auto* table = rig.find<QComboBox>(QStringLiteral("faultTable"));
    table->setCurrentIndex(1);
    EXPECT_EQ(faults()->model()->rowCount(), wire::kDongleFaultCount);
    table->setCurrentIndex(2);
    EXPECT_EQ(faults()->model()->rowCount(), wire::kRobotFaultCount);
}

TEST_F(FaultsTest, SearchedByCodeSubjectAndWords) {
    search(QStringLiteral("MOTOR 5"));
    EXPECT_EQ(faults()->model()->rowCount(), 2);
    search(QStringLiteral("0x29"));
    ASSERT_EQ(faults()->model()->rowCount(), 2);
    EXPECT_TRUE(faults()
                    ->model()
                    ->index(0, ui::FaultsModel::Meaning)
                    .data()
                    .toString()
                    .contains(QStringLiteral("sent")));
    search(QStringLiteral("no such words"));
    EXPECT_EQ(faults()->model()->rowCount(), 0);
}

TEST_F(FaultsTest, ACodeThatArrivesLeadsHereByEnterAndByDoubleClick) {
    rig.simulate("error", -1, 43);
    ASSERT_TRUE(
        waitUntil([this] { return eventRow(QStringLiteral("Robot 2: Message could not be sent")) >= 0; }));
    search(QStringLiteral("hides it"));
    const int row = eventRow(QStringLiteral("Robot 2: Message"));
    events()->setCurrentIndex(events()->model()->index(row, 0));
    events()->setFocus();
    rig.press(Qt::Key_Return);
    EXPECT_TRUE(waitUntil([this] { return isInFront(); }));
    EXPECT_TRUE(currentCode().startsWith(QStringLiteral("43 "))) << currentCode().toStdString();
    EXPECT_EQ(faults()->currentIndex().siblingAtColumn(ui::FaultsModel::Seen).data().toString(),
              QStringLiteral("1 \u00d7"));
    faults()->setCurrentIndex({});
    const QPoint place = events()->visualRect(events()->model()->index(row, 2)).center();
    QTest::mouseClick(events()->viewport(), Qt::LeftButton, Qt::NoModifier, place);
    QTest::mouseDClick(events()->viewport(), Qt::LeftButton, Qt::NoModifier, place);
    EXPECT_TRUE(currentCode().startsWith(QStringLiteral("43 ")));
}

TEST_F(FaultsTest, AnEventWithoutACodeLeadsNowhere) {
    events()->setCurrentIndex(events()->model()->index(0, 0));
    events()->setFocus();
    rig.press(Qt::Key_Return);
    EXPECT_FALSE(isInFront());
}

TEST(FaultsModel, CodesInNoTableAreCounted) {
    ui::FaultsModel model;
    model.noteSeen(200);
    model.noteSeen(41);
    model.noteSeen(41);
    EXPECT_EQ(model.unknownSeen(), 1);
    EXPECT_EQ(model.index(41, ui::FaultsModel::Seen).data().toString(), QStringLiteral("2 \u00d7"));
    EXPECT_EQ(model.rowOf(ui::FaultTable::Robot, 47), wire::kDongleFaultCount + 47);
    EXPECT_EQ(model.rowOf(ui::FaultTable::Robot, 48), -1);
    EXPECT_EQ(model.rowOf(ui::FaultTable::Dongle, -1), -1);
}

}  // namespace
}  // namespace kickstand::test
