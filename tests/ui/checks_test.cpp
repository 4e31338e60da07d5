// Bench checks: every control to the wire, and what came of it back into the panel and onto a file.

#include <QAbstractButton>
#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QJsonDocument>
#include <QLabel>
#include <QMenu>
#include <QPrintDialog>
#include <QPrinter>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/thunderbots/commands.h"
#include "tests/ui/bench_rig.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

class ChecksTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.bench().goTo(QStringLiteral("checks"));
        set("checks_run_s", 5);
        // Six robots come out of the factory with batteries that differ.
        set("checks_least_battery_V", 140);
    }
    void set(const char* field, int value) {
        rig.find<ui::SignedSpinBox>(QString::fromLatin1(field))->setValue(value);
    }
    /// Leaves a part out.
    void without(std::initializer_list<const char*> parts) {
        for (const char* const part : parts) {
            auto* box = rig.find<QAbstractButton>(QStringLiteral("checks_%1").arg(QLatin1String(part)));
            if (box->isChecked()) box->click();
        }
    }
    QString words() { return rig.find<QLabel>(QStringLiteral("checksWords"))->text(); }
    bool waitForWords(const QString& part) {
        return waitUntil([this, &part] { return words().contains(part); });
    }
    QAbstractButton* button(const char* name) { return rig.find<QAbstractButton>(QString::fromLatin1(name)); }
    bool press(const char* name) {
        if (!waitUntil([this, name] { return button(name)->isEnabled(); })) return false;
        button(name)->click();
        return true;
    }
    QString cell(int row, int column) {
        return rig.find<QTableView>(QStringLiteral("checksTable"))
            ->model()
            ->index(row, column)
            .data()
            .toString();
    }
    /// Chooses robot 2, checks nothing of it but its wheels, and says that it stands free.
    void beginWithWheels() {
        rig.clickRobot(2);
        without({"dribbler", "kicker", "leds"});
        ASSERT_TRUE(press("checksStart"));
        ASSERT_TRUE(waitForWords(QStringLiteral("Does robot 2 stand")));
        rig.wire().clear();
        ASSERT_TRUE(press("checksYes"));
    }
};

TEST_F(ChecksTest, AWheelRunsOnTheWireAndIsAskedFor) {
    beginWithWheels();
    ASSERT_TRUE(rig.waitForAnyBlock(2, [](const wire::DriveBlock& block) {
        return block.run && block.wheels[0] == 60 && block.testClass == 4 && block.testTarget == 1;
    }));
    ASSERT_TRUE(waitForWords(QStringLiteral("Did wheel 1, front left, turn smoothly")));
    EXPECT_TRUE(rig.waitForBlock(2, [](const wire::DriveBlock& block) { return !block.run; }))
        << "it stands while the question is open";
    rig.wire().clear();
    ASSERT_TRUE(press("checksAgain"));
    ASSERT_TRUE(rig.waitForAnyBlock(2, [](const wire::DriveBlock& block) { return block.run; }));
    ASSERT_TRUE(waitForWords(QStringLiteral("Did wheel 1, front left, turn smoothly")));
    ASSERT_TRUE(press("checksYes"));
    ASSERT_TRUE(rig.waitForAnyBlock(2, [](const wire::DriveBlock& block) { return block.wheels[0] == -60; }));
    ASSERT_TRUE(waitForWords(QStringLiteral("robot clockwise")));
    ASSERT_TRUE(press("checksNo"));
    ASSERT_TRUE(waitUntil([this] { return cell(3, 4) == QStringLiteral("not seen"); }));
    EXPECT_EQ(cell(1, 1), QStringLiteral("Battery at rest"));
    EXPECT_EQ(cell(1, 2), QStringLiteral("≥ 14.00 V"));
    EXPECT_EQ(cell(2, 4), QStringLiteral("passed"));
    ASSERT_TRUE(press("checksStop"));
    ASSERT_TRUE(waitForWords(QStringLiteral("ended early")));
    EXPECT_FALSE(rig.snapshot()->intents[2].active());
}

TEST_F(ChecksTest, NothingMovesWhileThePersonHasNotSaidThatItStandsFree) {
    rig.clickRobot(2);
    without({"dribbler", "kicker", "leds"});
    rig.wire().clear();
    ASSERT_TRUE(press("checksStart"));
    ASSERT_TRUE(waitForWords(QStringLiteral("Does robot 2 stand")));
    for (const wire::DriveBlock& block : rig.wire().blocks(2))
        EXPECT_EQ(block, wire::brakedBlock());
    ASSERT_TRUE(press("checksSkip"));
    ASSERT_TRUE(waitForWords(QStringLiteral("Robot 2 failed nothing, but not all was checked")));
}

TEST_F(ChecksTest, ChargingNeedsTheRobotArmed) {
    rig.clickRobot(1);
    without({"wheels", "dribbler", "leds"});
    EXPECT_TRUE(waitUntil([this] { return button("checksArm")->isEnabled(); }));
    EXPECT_FALSE(button("checksStart")->isEnabled());
    EXPECT_TRUE(
        rig.find<QLabel>(QStringLiteral("checksNotice"))->text().contains(QStringLiteral("press Arm")));
    ASSERT_TRUE(press("checksArm"));
    ASSERT_TRUE(waitUntil([this] { return button("checksStart")->isEnabled(); }));
    ASSERT_TRUE(press("checksStart"));
    ASSERT_TRUE(waitForWords(QStringLiteral("Does robot 1 stand")));
    ASSERT_TRUE(press("checksYes"));
    ASSERT_TRUE(
        rig.waitForBlock(1, [](const wire::DriveBlock& block) { return block.charge && !block.run; }));
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(waitForWords(QStringLiteral("ended early")));
    ASSERT_TRUE(rig.waitForBlock(1, [](const wire::DriveBlock& block) { return !block.charge; }));
}

TEST_F(ChecksTest, TheSpaceBarStopsItAndAnswersNothing) {
    beginWithWheels();
    ASSERT_TRUE(waitForWords(QStringLiteral("Did wheel 1")));
    button("checksYes")->setFocus();
    rig.press(Qt::Key_Space);
    ASSERT_TRUE(rig.waitForStop());
    ASSERT_TRUE(waitForWords(QStringLiteral("ended early")));
}

TEST_F(ChecksTest, ClosingThePanelStopsIt) {
    beginWithWheels();
    auto* dock = rig.window().findChild<QWidget*>(QStringLiteral("checks"));
    ASSERT_NE(dock, nullptr);
    dock->close();
    ASSERT_TRUE(rig.waitForStop());
}

TEST_F(ChecksTest, ARobotThatIsNotHeardSaysWhyItCannotBegin) {
    rig.clickRobot(9);
    EXPECT_FALSE(button("checksStart")->isEnabled());
    EXPECT_TRUE(rig.find<QLabel>(QStringLiteral("checksNotice"))
                    ->text()
                    .contains(QStringLiteral("robot 9 is not heard")));
}

TEST_F(ChecksTest, LimitsAreRememberedAndTheUsualOnesComeBack) {
    set("checks_most_sag_V", 47);
    EXPECT_DOUBLE_EQ(rig.settings().value(QStringLiteral("checks/most_sag_V")).toDouble(), 0.47);
    rig.click(QStringLiteral("checksUsualLimits"));
    EXPECT_EQ(rig.find<ui::SignedSpinBox>(QStringLiteral("checks_most_sag_V"))->value(), 100);
    EXPECT_DOUBLE_EQ(rig.settings().value(QStringLiteral("checks/most_sag_V")).toDouble(), 1.0);
}

/// Names a file in a dialog and accepts it.
void accept(QFileDialog* dialog, const QString& path) {
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog))
        << "STOP keys have to reach the program";
    dialog->selectFile(path);
    QMetaObject::invokeMethod(dialog, "accept");
}

TEST_F(ChecksTest, TheWheelsSpeedIsToldInTurnsToo) {
    const auto* field = rig.find<ui::SignedSpinBox>(QStringLiteral("checks_wheel_speed"));
    const auto label = [field] {
        const QList<QLabel*> labels = field->parentWidget()->findChildren<QLabel*>();
        return *std::ranges::find_if(labels, [field](const QLabel* one) { return one->buddy() == field; });
    };
    set("checks_wheel_speed", 100);
    const QString before = label()->text();
    EXPECT_TRUE(before.endsWith(QStringLiteral(" rpm)"))) << before.toStdString();
    EXPECT_TRUE(waitUntil([&] { return label()->width() >= label()->sizeHint().width(); }));
    EXPECT_LE(field->mapTo(field->window(), QPoint(field->width(), 0)).x(),
              button("checksStop")->mapTo(field->window(), QPoint(button("checksStop")->width(), 0)).x());
    set("checks_wheel_speed", 30);
    EXPECT_NE(label()->text(), before);
}

TEST_F(ChecksTest, LimitsGoToAFileAndComeBackFromIt) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("limits.json"));
    set("checks_least_drop_V", 55);
    rig.click(QStringLiteral("checksSaveLimits"));
    accept(rig.window().findChild<QFileDialog*>(QStringLiteral("saveDialog")), path);
    ASSERT_TRUE(waitUntil([&path] { return QFile::exists(path); }));
    set("checks_least_drop_V", 20);
    rig.click(QStringLiteral("checksLoadLimits"));
    accept(rig.window().findChild<QFileDialog*>(QStringLiteral("loadDialog")), path);
    EXPECT_TRUE(waitUntil([this] {
        return rig.find<ui::SignedSpinBox>(QStringLiteral("checks_least_drop_V"))->value() == 55;
    }));
}

#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
TEST_F(ChecksTest, TheReportIsPrinted) {
    rig.clickRobot(0);
    without({"wheels", "dribbler", "kicker", "leds"});
    ASSERT_TRUE(press("checksStart"));
    ASSERT_TRUE(waitForWords(QStringLiteral("Does robot 0 stand")));
    ASSERT_TRUE(press("checksYes"));
    ASSERT_TRUE(waitForWords(QStringLiteral("Robot 0 passed its 2 steps. Not checked: wheels")));
    rig.find<QAction>(QStringLiteral("checksPrint"))->trigger();
    auto* dialog = rig.find<QPrintDialog>(QStringLiteral("printDialog"));
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->isVisible());
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("paper.pdf"));
    dialog->printer()->setOutputFormat(QPrinter::PdfFormat);
    dialog->printer()->setOutputFileName(path);
    dialog->done(QDialog::Accepted);
    ASSERT_TRUE(waitUntil([&path] { return QFile::exists(path); }));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().startsWith("%PDF"));
}
#endif

TEST_F(ChecksTest, TheReportIsSavedInEveryForm) {
    EXPECT_FALSE(button("checksReport")->isEnabled());
    rig.clickRobot(0);
    without({"wheels", "dribbler", "kicker", "leds"});
    ASSERT_TRUE(press("checksStart"));
    ASSERT_TRUE(waitForWords(QStringLiteral("Does robot 0 stand")));
    ASSERT_TRUE(press("checksYes"));
    ASSERT_TRUE(waitForWords(QStringLiteral("Robot 0 passed its 2 steps. Not checked: wheels")));
    ASSERT_TRUE(button("checksReport")->isEnabled());
    const QTemporaryDir folder;
    const std::pair<const char*, const char*> forms[] = {
        {"html", "Robot 0 passed its 2 steps."}, {"pdf", "%PDF"}, {"json", "\"passed\""}, {"txt", "passed"}};
    for (const auto& [suffix, part] : forms) {
        const QString path = folder.filePath(QStringLiteral("report.%1").arg(QLatin1String(suffix)));
        rig.find<QAction>(QStringLiteral("checksSave_%1").arg(QLatin1String(suffix)))->trigger();
        accept(rig.window().findChild<QFileDialog*>(QStringLiteral("saveDialog")), path);
        ASSERT_TRUE(waitUntil([&path] { return QFile::exists(path); })) << suffix;
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        EXPECT_TRUE(file.readAll().contains(part)) << suffix;
        ASSERT_TRUE(waitUntil([this] {
            return rig.window().findChild<QFileDialog*>(QStringLiteral("saveDialog")) == nullptr;
        }));
    }
}

}  // namespace
}  // namespace kickstand::test
