#pragma once

#include <QPointer>
#include <QSettings>
#include <QTemporaryDir>
#include <QWidget>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/engine/engine.h"
#include "core/ledger/ledger.h"
#include "core/thunderbots/snapshot.h"
#include "tests/ui/test_links.h"
#include "ui/shell/bench.h"
#include "ui/shell/connector.h"
#include "ui/shell/ledger_feed.h"
#include "ui/shell/main_window.h"
#include "ui/shell/stop_filter.h"
#include "ui/shell/system_view.h"
#include "ui/shell/theme.h"
#include "ui/thunderbots/thunderbots_view.h"

namespace kickstand::test {

/// Turns the event loop until `condition` holds. False when it did not within the watchdog's time.
bool waitUntil(const std::function<bool()>& condition);

/// The whole program but its main(): window, engine, and simulated devices whose wire can be read.
class BenchRig {
  public:
    BenchRig();
    ~BenchRig();

    /// Connects and waits until the robots are heard and their readings are current.
    [[nodiscard]] bool connectTo(const char* uri = "sim:thunderbots?robots=0-5");
    [[nodiscard]] bool waitForSnapshot(const std::function<bool(const thunderbots::Snapshot&)>& condition);
    /// Waits for a drive block on the wire, of those after wire().clear().
    [[nodiscard]] bool waitForBlock(
        int robot, const std::function<bool(const thunderbots::wire::DriveBlock&)>& condition);
    [[nodiscard]] bool waitForStop() {
        return waitUntil([this] { return client().isStopped(); });
    }
    /// The same where the block may be followed by others: of all those since wire().clear().
    [[nodiscard]] bool waitForAnyBlock(
        int robot, const std::function<bool(const thunderbots::wire::DriveBlock&)>& condition);
    /// Waits until no command is on its way any more.
    [[nodiscard]] bool settle();
    /// Re-arms and waits until the window has seen both the STOP and its end: what is typed before that is
    /// dropped, as it should be.
    [[nodiscard]] bool rearm();
    void simulate(const char* action, int unit, double value);

    const thunderbots::Snapshot* snapshot() const { return ui::snapshotOf(bench_->session()); }
    ui::EngineClient& client() { return *client_; }
    ui::Bench& bench() { return *bench_; }
    ui::Theme& theme() { return *theme_; }
    ui::MainWindow& window() { return *window_; }
    QSettings& settings() { return *settings_; }
    LinkBoard& board() { return *board_; }
    Ledger& ledger() { return ledger_; }
    WireLog& wire() { return board_->wire; }

    /// A control of the window, by its name. It must be there.
    template <class Widget>
    Widget* find(const QString& name) {
        auto* widget = window_->findChild<Widget*>(name);
        EXPECT_NE(widget, nullptr) << name.toStdString();
        return widget;
    }
    void click(const QString& name);
    void clickRobot(int robot, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// Types a key into whatever has the focus.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// Types a number into a wheel's field and confirms it.
    void typeWheel(int wheel, const QString& number);

  private:
    QTemporaryDir folder_;
    std::unique_ptr<QSettings> settings_;
    std::shared_ptr<LinkBoard> board_ = std::make_shared<LinkBoard>();
    std::unique_ptr<ui::Theme> theme_;
    std::unique_ptr<Engine> engine_;
    std::unique_ptr<ui::EngineClient> client_;
    Ledger ledger_{":memory:"};
    std::unique_ptr<ui::LedgerFeed> feed_;
    ui::SystemRegistry systems_;
    std::unique_ptr<ui::Bench> bench_;
    std::unique_ptr<ui::StopFilter> stopFilter_;
    std::unique_ptr<ui::MainWindow> window_;
};

/// A test on a window that is connected to six simulated robots.
class BenchTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(rig.connectTo()); }

    BenchRig rig;
};

}  // namespace kickstand::test
