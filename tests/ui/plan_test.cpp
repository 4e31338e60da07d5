// The plan editor and the robot's panel in the whole window, on a simulated NXT: from the button to the bytes
// on the wire.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
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
#include "ui/shell/main_window.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/theme.h"
#include "ui/shell/workbench.h"
#include "ui/thunderbots/thunderbots_view.h"

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

class NxtLinks final : public LinkProvider {
  public:
    explicit NxtLinks(Written& written) : written_(written) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
        return fail(Errc::Unsupported, toString(uri));
    }
    Result<ProvidedByteLink> makeByteLink(const LinkUri&, Scheduler& scheduler) override {
        auto sim = std::make_shared<motionplan::sim::NxtSim>(scheduler);
        auto link =
            std::make_unique<TappedByteLink>(std::make_unique<PacedByteLink>(scheduler, *sim), scheduler);
        link->addObserver(&written_);
        ProvidedByteLink provided;
        provided.link = std::move(link);
        provided.sim = &sim->control();
        provided.keepAlive = std::move(sim);
        return provided;
    }
    void discover(Scheduler& scheduler, std::function<void(std::vector<FoundDevice>)> found) override {
        scheduler.post([found = std::move(found)] { found({}); });
    }

  private:
    Written& written_;
};

class PlanWindow : public testing::Test {
  protected:
    void SetUp() override {
        EngineOptions options;
        options.heartbeatLimit = std::chrono::seconds(10);
        engine_ = std::make_unique<Engine>(std::make_unique<NxtLinks>(written), options);
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
    QString text(const char* label) { return find<QLabel>(label)->text(); }

    Written written;
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

TEST_F(PlanWindow, StepsAreDraggedIntoAnotherOrder) {
    add("Forward", 25);
    add("Turn right", 84);
    auto* list = find<QListWidget>("planSteps");
    ASSERT_TRUE(list->model()->moveRow({}, 1, {}, 0));
    ASSERT_TRUE(waitFor([this] { return step(0).contains(QStringLiteral("1   turn right")); }));
    click("planUndo");
    EXPECT_EQ(step(0), QStringLiteral("1   forward 25 cm   0d"));
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
}

TEST_F(PlanWindow, AZeroByteIsMarkedAndSplit) {
    add("Forward", 1000);
    EXPECT_TRUE(step(0).contains(QStringLiteral("zero byte")));
    EXPECT_TRUE(text("planNotice").contains(QStringLiteral("Zero bytes: 1")));
    click("planSplit");
    EXPECT_EQ(step(0), QStringLiteral("1   forward 900 cm   1f"));
    EXPECT_EQ(step(1), QStringLiteral("2   forward 100 cm   17"));
    EXPECT_TRUE(text("planNotice").isEmpty());
}

TEST_F(PlanWindow, APlanGoesToTheRobotRunsLitAndIsStopped) {
    add("Forward", 300);
    add("Turn right", 84);
    find<QSpinBox>("planId")->setValue(9);
    click("planSend4");
    ASSERT_TRUE(waitFor([this] { return text("planSlot4") == QStringLiteral("4: plan 9\n2 step(s)"); }));
    EXPECT_EQ(written.messages(), (std::vector<std::string>{"05 ff 04", "00 09 04 19 5c"}));
    // Full now: it offers an update under the resident's ID.
    EXPECT_EQ(find<QAbstractButton>("planSend4")->text(), QStringLiteral("Update"));
    click("planExecute4");
    ASSERT_TRUE(waitFor([this] { return find<ui::PlanPath>("planPath")->executing() == 1; }));
    EXPECT_TRUE(bench->isMoving());
    EXPECT_TRUE(text("planState").contains(QStringLiteral("Plan 9, step 1 of 2")));
    click("planAdjust");
    ASSERT_TRUE(waitFor([this] { return written.messages().back() == "06 09 04 00 e2"; }));
    ASSERT_TRUE(waitFor([this] { return !client->hasPending(); }));
    click("planStop");
    ASSERT_TRUE(waitFor([this] { return !state()->active(); }));
    EXPECT_EQ(written.messages().back(), "01");
    ASSERT_TRUE(waitFor([this] { return find<ui::PlanPath>("planPath")->executing() == 0; }));
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
