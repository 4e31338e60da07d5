// The plan editor and the robot's panel in the whole window, on a simulated NXT: from the button to the bytes
// on the wire.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <mutex>
#include <set>

#include <gtest/gtest.h>

#include "core/base/hex.h"
#include "core/ledger/ledger.h"
#include "core/link/paced/paced_byte_link.h"
#include "core/link/tapped_byte_link.h"
#include "core/motionplan/sim/nxt_sim.h"
#include "ui/motionplan/motionplan_view.h"
#include "ui/motionplan/plan_path.h"
#include "ui/shell/bench.h"
#include "ui/shell/connector.h"
#include "ui/shell/main_window.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/theme.h"
#include "ui/shell/workbench.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/widgets/banner.h"

namespace kickstand::test {
namespace {

constexpr int kWatchdog_ms = 20'000;

bool waitFor(const std::function<bool()>& condition) {
    QElapsedTimer watch;
    watch.start();
    while (!condition()) {
        if (watch.elapsed() > kWatchdog_ms) return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

/// The messages that a host has written, as hex.
class Written final : public ByteTapObserver {
  public:
    void observe(const ByteTapRecord& record) override {
        if (record.kind != ByteTapRecord::Kind::Sent) return;
        const std::lock_guard lock(mutex_);
        parser_.feed(record.data, [this](const motionplan::wire::Telegram& telegram) {
            const auto* write = std::get_if<motionplan::wire::MessageWrite>(&telegram);
            if (write != nullptr)
                messages_.push_back(toHex(write->content.view().first(write->content.size() - 1)));
        });
    }
    std::vector<std::string> messages() {
        const std::lock_guard lock(mutex_);
        return messages_;
    }

  private:
    std::mutex mutex_;
    motionplan::wire::TelegramParser parser_;
    std::vector<std::string> messages_;
};

/// The serial ports there are.
struct Ports {
    std::mutex mutex;
    std::vector<BytePort> now;

    void set(std::vector<BytePort> ports) {
        const std::lock_guard lock(mutex);
        now = std::move(ports);
    }
    std::vector<BytePort> get() {
        const std::lock_guard lock(mutex);
        return now;
    }
};

class NxtLinks final : public LinkProvider {
  public:
    NxtLinks(Written& written, Ports& ports) : written_(written), ports_(ports) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
        return fail(Errc::Unsupported, toString(uri));
    }
    Result<ProvidedByteLink> makeByteLink(const LinkUri&, Scheduler& scheduler) override {
        auto sim = std::make_shared<motionplan::sim::NxtSim>(scheduler);
        // Slot 2 has a plan that somebody else has put there.
        const auto create = motionplan::wire::encodeMessage(
            {.kind = motionplan::wire::MessageKind::Create, .plan = 5, .slot = 2, .movements = {0x1E, 0x1E}});
        sim->program().command(create->view(), scheduler.now());
        auto link =
            std::make_unique<TappedByteLink>(std::make_unique<PacedByteLink>(scheduler, *sim), scheduler);
        link->addObserver(&written_);
        ProvidedByteLink provided;
        provided.link = std::move(link);
        provided.sim = &sim->control();
        provided.keepAlive = std::move(sim);
        return provided;
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([this, found = std::move(found)] { found({{}, ports_.get()}); });
    }

  private:
    Written& written_;
    Ports& ports_;
};

class PlanWindow : public testing::Test {
  protected:
    void SetUp() override {
        EngineOptions options;
        options.heartbeatLimit = std::chrono::seconds(10);
        engine_ = std::make_unique<Engine>(std::make_unique<NxtLinks>(written, ports), options);
        client = std::make_unique<ui::EngineClient>(*engine_);
        systems_.add(std::make_unique<ui::ThunderbotsView>(ledger_));
        systems_.add(std::make_unique<ui::MotionplanView>());
        bench = std::make_unique<ui::Bench>(*client, systems_, *settings_);
        window = std::make_unique<ui::MainWindow>(*bench, *theme_);
        window->resize(1280, 800);
        window->show();
        window->workbench().makePanels();
        bench->connectTo(*parseLinkUri("sim:motionplan"));
        ASSERT_TRUE(waitFor([this] { return state() != nullptr && state()->answers; }));
        ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("planQuery")->isEnabled(); }));
    }
    void TearDown() override {
        window.reset();
        engine_->shutdown();
    }

    const motionplan::Snapshot* state() { return ui::planSnapshotOf(bench->session()); }
    template <class Widget>
    Widget* find(const char* name) {
        auto* widget = window->findChild<Widget*>(QLatin1String(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void click(const char* name) {
        auto* button = find<QAbstractButton>(name);
        EXPECT_TRUE(button->isEnabled()) << name;
        button->click();
    }
    void add(const char* way, int amount) {
        auto* ways = find<QComboBox>("planWay");
        ways->setCurrentIndex(ways->findText(QLatin1String(way)));
        find<QSpinBox>("planAmount")->setValue(amount);
        click("planAdd");
    }
    QString step(int row) { return find<QListWidget>("planSteps")->item(row)->text(); }
    int steps() { return find<QListWidget>("planSteps")->count(); }
    void acceptFile(const char* name, const QString& path) {
        auto* dialog = find<QFileDialog>(name);
        EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog))
            << "STOP keys have to reach the program";
        dialog->selectFile(path);
        QMetaObject::invokeMethod(dialog, "accept");
        ASSERT_TRUE(waitFor([&] { return window->findChild<QFileDialog*>(QLatin1String(name)) == nullptr; }));
    }
    static QByteArray contentOf(const QString& path) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }
    QString text(const char* label) { return find<QLabel>(label)->text(); }

    Written written;
    Ports ports;
    std::unique_ptr<ui::EngineClient> client;
    std::unique_ptr<ui::Bench> bench;
    std::unique_ptr<ui::MainWindow> window;

  private:
    QTemporaryDir folder_;
    std::unique_ptr<QSettings> settings_ =
        std::make_unique<QSettings>(folder_.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
    std::unique_ptr<ui::Theme> theme_ = std::make_unique<ui::Theme>(*settings_);
    Ledger ledger_{":memory:"};
    ui::SystemRegistry systems_;
    std::unique_ptr<Engine> engine_;
};

TEST_F(PlanWindow, ShowsThePanelsOfItsSystemAndWithholdsTheOthers) {
    const auto shown = [this](const char* id) { return !find<ui::PanelDock>(id)->isHidden(); };
    EXPECT_TRUE(shown("plan"));
    EXPECT_TRUE(shown("plan-robot"));
    EXPECT_TRUE(shown("events"));
    EXPECT_FALSE(shown("drive"));
    EXPECT_FALSE(shown("kick"));
}

TEST_F(PlanWindow, StepsAreAddedChangedMovedAndUndone) {
    EXPECT_FALSE(find<QAbstractButton>("planSend0")->isEnabled());
    add("Forward", 25);
    add("Turn right", 84);
    EXPECT_EQ(step(0), QStringLiteral("1   forward 25 cm   0d"));
    EXPECT_EQ(step(1), QStringLiteral("2   turn right 84\u00b0   5c"));
    click("planDuplicate");
    EXPECT_EQ(steps(), 3);
    click("planUp");
    click("planUp");
    EXPECT_EQ(step(0), QStringLiteral("1   turn right 84\u00b0   5c"));
    click("planRemove");
    EXPECT_EQ(steps(), 2);
    click("planUndo");
    EXPECT_EQ(steps(), 3);
    // The first step up went past its own like, which changes nothing.
    click("planUndo");
    click("planUndo");
    EXPECT_EQ(steps(), 2);
    click("planRedo");
    EXPECT_EQ(steps(), 3);
    EXPECT_TRUE(text("planLength").contains(QStringLiteral("3 of 55")));
}

TEST_F(PlanWindow, StepsAreRemovedAndBroughtBackByKeys) {
    add("Forward", 25);
    add("Turn right", 84);
    auto* list = find<QListWidget>("planSteps");
    list->setFocus();
    window->activateWindow();
    ASSERT_TRUE(waitFor([list] { return list->hasFocus(); }));
    QTest::keyClick(list, Qt::Key_Delete);
    EXPECT_EQ(steps(), 1);
    QTest::keyClick(list, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(steps(), 2);
    QTest::keyClick(list, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(steps(), 1);
    // Of the steps alone: an amount that is typed has its own undo, and its own Delete.
    add("Back", 3);
    auto* amount = find<QSpinBox>("planAmount");
    amount->setFocus();
    ASSERT_TRUE(waitFor([amount] { return amount->hasFocus(); }));
    QTest::keyClick(amount, Qt::Key_Delete);
    EXPECT_EQ(steps(), 2);
}

TEST_F(PlanWindow, StepsAreDraggedIntoAnotherOrder) {
    add("Forward", 25);
    add("Turn right", 84);
    auto* list = find<QListWidget>("planSteps");
    ASSERT_TRUE(list->model()->moveRow({}, 1, {}, 0));
    ASSERT_TRUE(waitFor([this] { return step(0).contains(QStringLiteral("1   turn right")); }));
    click("planUndo");
    EXPECT_EQ(step(0), QStringLiteral("1   forward 25 cm   0d"));
}

TEST_F(PlanWindow, NoStepCanBeDroppedOntoAnother) {
    add("Forward", 25);
    add("Turn right", 84);
    const auto* list = find<QListWidget>("planSteps");
    for (int row = 0; row < list->count(); ++row) {
        EXPECT_FALSE(list->item(row)->flags().testFlag(Qt::ItemIsDropEnabled)) << row;
        EXPECT_TRUE(list->item(row)->flags().testFlag(Qt::ItemIsDragEnabled)) << row;
    }
}

TEST_F(PlanWindow, APlanIsSavedAndOpenedAgain) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("square.plan"));
    add("Forward", 25);
    add("Turn left back", 84);
    click("planSave");
    acceptFile("saveDialog", path);
    ASSERT_TRUE(waitFor([&path] { return QFile::exists(path); }));
    EXPECT_EQ(contentOf(path), QByteArray("forward 25\nturn left back 84\n"));
    click("planRemove");
    click("planRemove");
    ASSERT_EQ(steps(), 0);
    click("planOpen");
    acceptFile("openFilesDialog", path);
    ASSERT_TRUE(waitFor([this] { return steps() == 2; }));
    EXPECT_EQ(step(1), QStringLiteral("2   turn left back 84\u00b0   7c"));
    click("planUndo");
    EXPECT_EQ(steps(), 0);
}

TEST_F(PlanWindow, AFileThatIsNoPlanLeavesTheEditorAsItIs) {
    const QTemporaryDir folder;
    add("Forward", 25);
    const std::pair<QByteArray, const char*> files[] = {
        {"", "holds no movement"},
        {"# only a comment\n\n", "holds no movement"},
        {QByteArray("\x7f"
                    "ELF\x02\x01\0",
                    7),
         "is not a plan"},
        {"forward 25\njump 3\n", "is not a plan"},
    };
    int number = 0;
    for (const auto& [content, said] : files) {
        const QString path = folder.filePath(QStringLiteral("%1.txt").arg(++number));
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        click("planOpen");
        acceptFile("openFilesDialog", path);
        const QString expected = QStringLiteral("%1.txt %2").arg(number).arg(QLatin1String(said));
        EXPECT_TRUE(waitFor([&] { return text("planNotice").contains(expected); }))
            << text("planNotice").toStdString();
        EXPECT_EQ(steps(), 1);
    }
}

TEST_F(PlanWindow, APlanThatIsTooLongIsNotSentAndSaidToBe) {
    add("Forward", 1);
    const auto enabled = [this](const char* name) { return find<QAbstractButton>(name)->isEnabled(); };
    for (int count = 1; count < motionplan::wire::kMostMovements; ++count)
        click("planDuplicate");
    EXPECT_TRUE(text("planLength").contains(QStringLiteral("55 of 55")));
    EXPECT_TRUE(enabled("planSend0"));
    click("planDuplicate");
    EXPECT_FALSE(enabled("planSend0"));
    EXPECT_TRUE(text("planNotice").contains(QStringLiteral("56"))) << text("planNotice").toStdString();
    // A trigger plan has no slot in its header, and room for one more.
    EXPECT_TRUE(enabled("planSetTrigger"));
    click("planDuplicate");
    EXPECT_FALSE(enabled("planSetTrigger"));
    click("planUndo");
    click("planUndo");
    EXPECT_TRUE(enabled("planSend0"));
    EXPECT_TRUE(text("planNotice").isEmpty());
}

TEST_F(PlanWindow, WhatHasNoCodeIsAddedAsItsExactSum) {
    find<QSpinBox>("planAmount")->setValue(38);
    EXPECT_TRUE(text("planOffer").contains(QStringLiteral("forward 35 cm + forward 3 cm")));
    add("Forward", 38);
    EXPECT_EQ(steps(), 2);
    auto* ways = find<QComboBox>("planWay");
    ways->setCurrentIndex(ways->findText(QStringLiteral("Turn left")));
    find<QSpinBox>("planAmount")->setValue(85);
    EXPECT_FALSE(find<QAbstractButton>("planAdd")->isEnabled());
    EXPECT_TRUE(text("planOffer").contains(QStringLiteral("turn left 84 or turn left 87")));
    find<QSpinBox>("planAmount")->setValue(5000);
    EXPECT_FALSE(find<QAbstractButton>("planAdd")->isEnabled());
    EXPECT_TRUE(text("planOffer").contains(QStringLiteral("No plan is long enough")));
}

TEST_F(PlanWindow, AZeroByteIsMarkedAndSplit) {
    add("Forward", 1000);
    EXPECT_TRUE(step(0).contains(QStringLiteral("zero byte")));
    EXPECT_TRUE(text("planNotice").contains(QStringLiteral("Zero bytes: 1")));
    click("planSplit");
    EXPECT_EQ(step(0), QStringLiteral("1   forward 900 cm   1f"));
    EXPECT_EQ(step(1), QStringLiteral("2   forward 100 cm   17"));
    EXPECT_TRUE(text("planNotice").isEmpty());
    // Those that no other plan avoids are marked too.
    EXPECT_TRUE(text("planHeader").contains(QStringLiteral("zero byte")));
    EXPECT_TRUE(find<QAbstractButton>("planSend0")
                    ->toolTip()
                    .contains(QStringLiteral("00 01 00 1f 17; zero bytes, counted from 0: 0, 2")));
    EXPECT_TRUE(find<QAbstractButton>("planSend3")
                    ->toolTip()
                    .contains(QStringLiteral("00 01 03 1f 17; zero bytes, counted from 0: 0")));
}

TEST_F(PlanWindow, StopGoesBeforeWhatWaitsAndToARobotThatIsSilent) {
    click("planQuery");
    click("planStop");
    ASSERT_TRUE(waitFor([this] { return !client->hasPending(); }));
    EXPECT_EQ(std::ranges::count(written.messages(), "05 ff 04"), 0);
    const auto stops = [this] { return std::ranges::count(written.messages(), "01"); };
    EXPECT_GE(stops(), 1);
    bench->submit(SimPerform{"reply-loss", -1, 1});
    ASSERT_TRUE(waitFor([this] { return !state()->answers; }));
    ASSERT_TRUE(waitFor([this] { return !find<QAbstractButton>("planQuery")->isEnabled(); }));
    const auto before = stops();
    click("planStop");
    ASSERT_TRUE(waitFor([&] { return stops() > before; }));
}

TEST_F(PlanWindow, APlanGoesToTheRobotRunsLitAndIsStopped) {
    add("Forward", 300);
    add("Turn right", 84);
    find<QSpinBox>("planId")->setValue(9);
    click("planSend4");
    ASSERT_TRUE(waitFor([this] { return text("planSlot4") == QStringLiteral("4: plan 9\n2 step(s)"); }));
    EXPECT_EQ(written.messages(), (std::vector<std::string>{"05 ff 04", "00 09 04 19 5c", "05 ff 04"}));
    // Full now: it offers an update under the resident's ID.
    EXPECT_EQ(find<QAbstractButton>("planSend4")->text(), QStringLiteral("Update"));
    click("planExecute4");
    // No second one while the first is on its way.
    EXPECT_FALSE(find<QAbstractButton>("planExecute4")->isEnabled());
    EXPECT_FALSE(find<QAbstractButton>("planExecute3")->isEnabled());
    ASSERT_TRUE(waitFor([this] { return find<ui::PlanPath>("planPath")->executing() == 1; }));
    EXPECT_EQ(step(0), QStringLiteral("1   forward 300 cm   19   \u25b6 executing"));
    EXPECT_EQ(step(1), QStringLiteral("2   turn right 84\u00b0   5c"));
    EXPECT_TRUE(text("planElsewhere").isEmpty());
    EXPECT_TRUE(bench->isMoving());
    EXPECT_TRUE(text("planState").contains(QStringLiteral("Plan 9, step 1 of 2")));
    EXPECT_EQ(text("planProgress"), QStringLiteral("executing: forward 300 cm"));
    click("planAdjust");
    ASSERT_TRUE(waitFor([this] { return written.messages().back() == "06 09 04 00 e2"; }));
    ASSERT_TRUE(waitFor([this] { return !client->hasPending(); }));
    click("planStop");
    ASSERT_TRUE(waitFor([this] { return !state()->active(); }));
    EXPECT_EQ(written.messages().back(), "01");
    ASSERT_TRUE(waitFor([this] { return find<ui::PlanPath>("planPath")->executing() == 0; }));
    EXPECT_EQ(step(0), QStringLiteral("1   forward 300 cm   19"));
}

TEST_F(PlanWindow, AnExecuteThatNothingAnswersIsLeftToThePerson) {
    add("Forward", 300);
    click("planSend0");
    ASSERT_TRUE(waitFor([this] { return !client->hasPending(); }));
    ASSERT_TRUE(waitFor([this] { return state()->slotStates[0].plan == 1; }));
    bench->submit(SimPerform{"lose-next", -1, 1});
    click("planExecute0");
    ASSERT_TRUE(waitFor([this] {
        return text("planProgress").contains(QStringLiteral("nothing that confirms it came back"));
    }));
    ASSERT_TRUE(waitFor([this] {
        return text("planRobotNotice").contains(QStringLiteral("if it stands, stop the plan to be sure"));
    }));
    EXPECT_EQ(text("planState"), QStringLiteral("Plan 1"));
    EXPECT_EQ(text("planSlot0"), QStringLiteral("0: plan 1, may be executing\n1 step(s)"));
    EXPECT_TRUE(bench->isMoving());
    EXPECT_FALSE(find<QAbstractButton>("planExecute0")->isEnabled());
    client->stop(StopReason::Person);
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("planExecute0")->isEnabled(); }));
    EXPECT_EQ(text("planState"), QStringLiteral("At rest"));
    ASSERT_TRUE(waitFor(
        [this] { return !text("planRobotNotice").contains(QStringLiteral("stop the plan to be sure")); }));
    EXPECT_EQ(std::ranges::count(written.messages(), "03 01 00"), 1);
}

TEST_F(PlanWindow, WhyAPlanOfSomebodyElseIsNotDrawnIsSaid) {
    click("planQuery");
    ASSERT_TRUE(
        waitFor([this] { return text("planSlot2") == QStringLiteral("2: plan 5\nsteps not known"); }));
    EXPECT_TRUE(
        find<QLabel>("planSlot2")->toolTip().contains(QStringLiteral("not sent over this connection")));
    ASSERT_TRUE(waitFor([this] { return !client->hasPending(); }));
    click("planExecute2");
    ASSERT_TRUE(waitFor([this] {
        return text("planElsewhere")
            .contains(QStringLiteral("Plan 5 executes and is not drawn: it was not sent"));
    }));
    EXPECT_EQ(find<ui::PlanPath>("planPath")->executing(), 0);
    click("planStop");
    ASSERT_TRUE(waitFor([this] { return text("planElsewhere").isEmpty(); }));
}

TEST_F(PlanWindow, WhyAPlanThatWasChangedHereIsNotDrawnIsSaid) {
    add("Forward", 900);
    click("planSend0");
    ASSERT_TRUE(waitFor([this] { return state()->slotStates[0].plan == 1; }));
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("planExecute0")->isEnabled(); }));
    click("planExecute0");
    ASSERT_TRUE(waitFor([this] { return find<ui::PlanPath>("planPath")->executing() == 1; }));
    add("Turn left", 90);
    EXPECT_TRUE(text("planElsewhere").contains(QStringLiteral("another one than the plan here")));
    EXPECT_EQ(find<ui::PlanPath>("planPath")->executing(), 0);
    click("planUndo");
    EXPECT_TRUE(text("planElsewhere").isEmpty());
    EXPECT_EQ(find<ui::PlanPath>("planPath")->executing(), 1);
}

TEST_F(PlanWindow, StopReachesTheRobotAndNothingIsSentWhileItIsLatched) {
    add("Forward", 900);
    click("planSend0");
    ASSERT_TRUE(waitFor([this] { return state()->slotStates[0].plan == 1; }));
    click("planExecute0");
    ASSERT_TRUE(waitFor([this] { return state()->execution.step == 1; }));
    client->stop(StopReason::Person);
    ASSERT_TRUE(waitFor([this] { return !state()->active(); }));
    EXPECT_EQ(written.messages().back(), "01");
    click("planExecute0");
    ASSERT_TRUE(waitFor([this] { return !text("planRobotNotice").isEmpty(); }));
    EXPECT_EQ(written.messages().back(), "01");
    client->rearm();
}

TEST_F(PlanWindow, TheTriggerPlanIsSetAndSaidToBeDangerous) {
    add("Back", 50);
    find<QSpinBox>("planId")->setValue(7);
    click("planSetTrigger");
    ASSERT_TRUE(waitFor([this] { return text("planTrigger").contains(QStringLiteral("plan 7")); }));
    EXPECT_EQ(written.messages().back(), "08 07 32");
    EXPECT_TRUE(text("planWarning").contains(QStringLiteral("starts its trigger plan")));
    EXPECT_FALSE(bench->view()->hazards(bench->session()->system).empty());
}

TEST_F(PlanWindow, TheTriggerPlanIsReadWithoutAQuestion) {
    ASSERT_TRUE(waitFor([this] { return text("planTrigger") == QStringLiteral("Trigger plan: none"); }));
    EXPECT_TRUE(written.messages().empty());
    EXPECT_TRUE(text("planWarning").endsWith(QStringLiteral("the robot goes on with its plan.")));
    EXPECT_TRUE(bench->view()->hazards(bench->session()->system).empty());
}

TEST_F(PlanWindow, AsLongAsNobodyKnowsOfATriggerPlanThatIsSaidAndAskedAboutBeforeTheWindowCloses) {
    bench->submit(SimPerform{"program", -1, 0});
    bench->submit(SimPerform{"plugged", -1, 0});
    ASSERT_TRUE(waitFor([this] { return state()->outOfReach; }));
    bench->submit(SimPerform{"plugged", -1, 1});
    ASSERT_TRUE(waitFor([this] { return state()->connections == 2 && state()->answers; }));
    ASSERT_TRUE(waitFor([this] { return text("planTrigger") == QStringLiteral("Trigger plan: not known"); }));
    EXPECT_TRUE(text("planWarning").contains(QStringLiteral("or starts its trigger plan")));
    window->close();
    const auto* warning = window->findChild<QMessageBox*>(QStringLiteral("liveWarning"));
    ASSERT_NE(warning, nullptr);
    EXPECT_TRUE(warning->informativeText().contains(QStringLiteral("whether the robot has a trigger plan")));
    EXPECT_TRUE(window->isVisible());
}

TEST_F(PlanWindow, TheBannerSaysOfStopWhatTheRobotHasSaid) {
    const auto banner = [this](const char* said) {
        return waitFor(
            [&] { return find<ui::Banner>("stoppedBanner")->text().contains(QLatin1String(said)); });
    };
    add("Forward", 900);
    click("planSend0");
    ASSERT_TRUE(waitFor([this] { return state()->slotStates[0].plan == 1; }));
    click("planExecute0");
    ASSERT_TRUE(waitFor([this] { return state()->execution.step == 1; }));
    bench->submit(SimPerform{"lose-next", -1, 100});
    ASSERT_TRUE(waitFor([this] { return !client->hasPending(); }));
    client->stop(StopReason::Person);
    EXPECT_TRUE(banner("Stop was sent 5 times and not confirmed: the robot may go on."));
    bench->submit(SimPerform{"plugged", -1, 0});
    EXPECT_TRUE(banner("it goes on with its plan or starts its trigger plan, and STOP cannot reach it"));
    bench->submit(SimPerform{"lose-next", -1, 0});
    bench->submit(SimPerform{"plugged", -1, 1});
    EXPECT_TRUE(banner("The robot stands, as it says itself."));
}

TEST_F(PlanWindow, ARobotOutOfReachIsSaidToBeSo) {
    bench->submit(SimPerform{"plugged", -1, 0});
    ASSERT_TRUE(waitFor([this] { return state()->outOfReach; }));
    ASSERT_TRUE(waitFor([this] {
        return text("planProgress")
            .contains(QStringLiteral(
                "it goes on with its plan or starts its trigger plan, and STOP cannot reach it"));
    }));
    EXPECT_FALSE(find<QAbstractButton>("planStop")->isEnabled());
}

/// The actions of a menu by their texts, once it has been filled.
QStringList textsOf(QMenu* menu) {
    QStringList texts;
    for (const QAction* action : menu->actions())
        texts << action->text();
    return texts;
}

TEST_F(PlanWindow, SerialPortsAreOfferedAsTheyComeAndGo) {
    const auto lookAgain = [this] { window->connector().lookAgain(); };
    const auto button = [this] { return window->findChild<QAbstractButton*>(QStringLiteral("startPort")); };
    client->submit(bench->sessionId(), Disconnect{});
    ASSERT_TRUE(waitFor([this] { return bench->session() == nullptr; }));
    EXPECT_EQ(button(), nullptr);
    BytePort port;
    port.name = "/dev/rfcomm0";
    port.description = "NXT";
    ports.set({port});
    lookAgain();
    ASSERT_TRUE(waitFor([&] { return button() != nullptr; }));
    EXPECT_EQ(button()->text(), QStringLiteral("Connect to rfcomm0 \u00b7 NXT as"));
    // Of the systems on serial ports those that the window shows.
    auto* systems = qobject_cast<QPushButton*>(button())->menu();
    EXPECT_EQ(textsOf(systems), QStringList{QStringLiteral("Motion plans")});
    QMenu* menu = window->connector().menu();
    emit menu->aboutToShow();
    EXPECT_TRUE(textsOf(menu).contains(QStringLiteral("rfcomm0 \u00b7 NXT")));
    systems->actions().constFirst()->trigger();
    ASSERT_TRUE(waitFor([this] { return bench->session() != nullptr; }));
    EXPECT_EQ(toString(bench->session()->uri), "serial:/dev/rfcomm0?protocol=motionplan");
    client->submit(bench->sessionId(), Disconnect{});
    ASSERT_TRUE(waitFor([this] { return bench->session() == nullptr; }));
    ports.set({});
    lookAgain();
    ASSERT_TRUE(waitFor([&] { return button() == nullptr; }));
    emit menu->aboutToShow();
    EXPECT_FALSE(textsOf(menu).contains(QStringLiteral("rfcomm0 \u00b7 NXT")));
}

TEST_F(PlanWindow, EveryControlHasANameOfItsOwn) {
    std::set<QString> names;
    for (const char* id : {"plan", "plan-robot"}) {
        for (const QWidget* widget : find<ui::PanelDock>(id)->findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const bool control = button != nullptr || qobject_cast<const QSpinBox*>(widget) != nullptr ||
                                 qobject_cast<const QComboBox*>(widget) != nullptr ||
                                 qobject_cast<const QListWidget*>(widget) != nullptr;
            if (!control || !widget->objectName().startsWith(QStringLiteral("plan"))) continue;
            EXPECT_TRUE(names.insert(widget->objectName()).second) << widget->objectName().toStdString();
            EXPECT_TRUE(!widget->accessibleName().isEmpty() ||
                        (button != nullptr && !button->text().isEmpty()))
                << widget->objectName().toStdString();
            EXPECT_NE(widget->focusPolicy() & Qt::TabFocus, 0) << widget->objectName().toStdString();
        }
    }
    EXPECT_GT(names.size(), 25U);
}

}  // namespace
}  // namespace kickstand::test
