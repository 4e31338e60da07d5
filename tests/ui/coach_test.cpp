// The panels COACH, TOWRP and Radio in the whole window, on simulated radios: from the button to the packets
// that the module is given.
#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <mutex>
#include <set>

#include <gtest/gtest.h>

#include "core/base/hex.h"
#include "core/coach/sim/coach_sim.h"
#include "core/framing/xbee_parser.h"
#include "core/link/paced/paced_byte_link.h"
#include "core/link/tapped_byte_link.h"
#include "ui/coach/chart_view.h"
#include "ui/coach/coach_view.h"
#include "ui/coach/helm_pad.h"
#include "ui/coach/morale_view.h"
#include "ui/shell/bench.h"
#include "ui/shell/main_window.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/theme.h"
#include "ui/shell/workbench.h"

namespace kickstand::test {
namespace {

using coach::CoachState;
using coach::TowrpState;

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

/// The packets that the program has given its module: destination and message, as "af05 03 70".
class Packets final : public ByteTapObserver {
  public:
    void observe(const ByteTapRecord& record) override {
        if (record.kind != ByteTapRecord::Kind::Sent) return;
        const std::lock_guard lock(mutex_);
        ByteView rest = record.data;
        for (ByteView data = parser_.next(rest); !data.empty(); data = parser_.next(rest)) {
            const auto frame = xbee::decodeFrame(data);
            const auto* packet = frame ? std::get_if<xbee::Tx16>(&*frame) : nullptr;
            if (packet == nullptr) continue;
            packets_.push_back(QStringLiteral("%1 ").arg(packet->destination, 4, 16).toStdString() +
                               toHex(packet->payload));
        }
    }
    bool holds(const std::string& packet) {
        const std::lock_guard lock(mutex_);
        return std::find(packets_.begin(), packets_.end(), packet) != packets_.end();
    }
    std::string last() {
        const std::lock_guard lock(mutex_);
        return packets_.empty() ? std::string() : packets_.back();
    }

  private:
    std::mutex mutex_;
    xbee::Parser parser_;
    std::vector<std::string> packets_;
};

class RadioLinks final : public LinkProvider {
  public:
    explicit RadioLinks(Packets& packets) : packets_(packets) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
        return fail(Errc::Unsupported, toString(uri));
    }
    Result<ProvidedByteLink> makeByteLink(const LinkUri& uri, Scheduler& scheduler) override {
        const auto options = coach::sim::parseSimOptions(uri);
        if (!options) return fail(options.error());
        auto sim = std::make_shared<coach::sim::CoachSim>(scheduler, *options);
        PacedLineOptions line;
        line.baud = 9600;
        auto link = std::make_unique<TappedByteLink>(
            std::make_unique<PacedByteLink>(scheduler, sim->module(0), std::move(line)), scheduler);
        link->addObserver(&packets_);
        ProvidedByteLink provided;
        provided.link = std::move(link);
        provided.sim = sim.get();
        provided.keepAlive = std::move(sim);
        return provided;
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([found = std::move(found)] { found({}); });
    }

  private:
    Packets& packets_;
};

/// What is plugged in, and how it stands: the test's to change.
struct FakePads {
    std::vector<ui::PadInfo> plugged;
    ui::PadState state{std::vector<double>(6, 0.0), std::vector<bool>(15, false)};
};

class FakeSource final : public ui::PadSource {
  public:
    explicit FakeSource(const FakePads& pads) : pads_(pads) {}

    void update() override { seen_ = pads_; }
    std::vector<ui::PadInfo> pads() const override { return seen_.plugged; }
    std::optional<ui::PadState> state(int id) const override {
        for (const ui::PadInfo& pad : seen_.plugged) {
            if (pad.id == id) return seen_.state;
        }
        return std::nullopt;
    }

  private:
    const FakePads& pads_;
    FakePads seen_;
};

// Of a standard controller.
constexpr std::size_t kLeftY = 1;
constexpr std::size_t kRightX = 2;
constexpr std::size_t kStopButton = 1;

class CoachWindow : public testing::Test {
  protected:
    void SetUp() override {
        EngineOptions options;
        options.heartbeatLimit = std::chrono::seconds(10);
        engine_ = std::make_unique<Engine>(std::make_unique<RadioLinks>(packets), options);
        client = std::make_unique<ui::EngineClient>(*engine_);
        systems_.add(std::make_unique<ui::CoachView>([this] { return std::make_unique<FakeSource>(pads); }));
        bench = std::make_unique<ui::Bench>(*client, systems_, *settings_);
        window = std::make_unique<ui::MainWindow>(*bench, *theme_);
        window->resize(1280, 800);
        window->show();
        window->workbench().makePanels();
    }
    void TearDown() override {
        window.reset();
        engine_->shutdown();
    }

    void connectTo(const char* uri) {
        bench->connectTo(*parseLinkUri(uri));
        ASSERT_TRUE(waitFor([this] {
            return state() != nullptr && (state()->link == coach::LinkState::Running ||
                                          state()->link == coach::LinkState::NoModule);
        }));
    }
    /// Starts the COACH of team 5, which pairs with its own boat.
    void pair(const char* uri = "sim:coach?fall=0") {
        connectTo(uri);
        ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("coachStart")->isEnabled(); }));
        bench->goTo(QStringLiteral("coach"));
        click("coachStart");
        ASSERT_TRUE(waitFor([this] { return state()->coach.state == CoachState::Paired; }));
        ASSERT_TRUE(waitFor([this] { return find<ui::HelmPad>("coachHelm")->isEnabled(); }));
    }
    /// Lets the crew of the own boat mutiny, and pairs with it first where the last mutiny took it.
    bool mutiny() {
        const auto paired = [this] { return state()->coach.state == CoachState::Paired; };
        if (!paired()) {
            click("coachEnd");
            if (!waitFor([this] { return find<QAbstractButton>("coachStart")->isEnabled(); })) return false;
            click("coachStart");
            if (!waitFor(paired)) return false;
        }
        bench->submit(SimPerform{"morale", 5, -10});
        return waitFor([this] { return find<ui::MoraleView>("coachMorale")->ring().has_value(); });
    }
    const coach::Snapshot* state() { return ui::coachOf(bench->session()); }
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
    QString text(const char* label) { return find<QLabel>(label)->text(); }
    bool sends(const std::string& packet) {
        return waitFor([this, &packet] { return packets.holds(packet); });
    }

    /// Plugs a gamepad in, switches it on, and waits until its sticks count.
    void takeGamepad() {
        pads.plugged = {{1, "Fake pad", "0011", true}};
        click("coachPad");
        ASSERT_TRUE(waitFor([this] { return text("coachPadState").contains(QStringLiteral("steers")); }));
    }
    /// The state that a chart shows lit; empty unless it is exactly one.
    QString lit(const char* chart) {
        QStringList names;
        for (const ui::ChartState& one : find<ui::ChartView>(chart)->chart().states) {
            if (one.current) names << one.name;
        }
        return names.size() == 1 ? names.front() : QString();
    }

    FakePads pads;
    Packets packets;
    std::unique_ptr<ui::EngineClient> client;
    std::unique_ptr<ui::Bench> bench;
    std::unique_ptr<ui::MainWindow> window;

  private:
    QTemporaryDir folder_;
    std::unique_ptr<QSettings> settings_ =
        std::make_unique<QSettings>(folder_.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
    std::unique_ptr<ui::Theme> theme_ = std::make_unique<ui::Theme>(*settings_);
    ui::SystemRegistry systems_;
    std::unique_ptr<Engine> engine_;
};

TEST_F(CoachWindow, SaysWhatIsMissingWhereThereIsNoRadio) {
    EXPECT_FALSE(text("coachEmpty").isEmpty());
    EXPECT_FALSE(text("towrpEmpty").isEmpty());
    connectTo("sim:coach?fresh=1");
    ASSERT_TRUE(waitFor([this] { return text("coachEmpty").contains(QStringLiteral("Radio panel")); }));
    EXPECT_TRUE(find<QAbstractButton>("radioFind")->isEnabled());
}

TEST_F(CoachWindow, StartsUpAndPairsWithItsOwnBoat) {
    find<QComboBox>("coachColor")->setCurrentIndex(1);
    pair();
    EXPECT_TRUE(packets.holds("af05 01 01"));
    EXPECT_TRUE(sends("af05 03 00"));
    ASSERT_TRUE(
        waitFor([this] { return find<ui::MoraleView>("coachMorale")->text() != QStringLiteral("–"); }));
    ASSERT_TRUE(waitFor([this] {
        return find<QPlainTextEdit>("coachConversation")->toPlainText().contains(QStringLiteral("TOWRP 5"));
    }));
}

TEST_F(CoachWindow, TheArrowKeysSteerFromTheFirstPressOn) {
    pair();
    auto* helm = find<ui::HelmPad>("coachHelm");
    QTest::keyPress(helm, Qt::Key_Up);
    EXPECT_TRUE(sends("af05 03 70"));
    EXPECT_TRUE(waitFor([this] { return bench->isMoving(); }));
    QTest::keyPress(helm, Qt::Key_Right);
    EXPECT_TRUE(sends("af05 03 7f"));
    QTest::keyRelease(helm, Qt::Key_Up);
    QTest::keyRelease(helm, Qt::Key_Right);
    EXPECT_TRUE(waitFor([this] { return packets.last() == "af05 03 00"; }));
    ASSERT_TRUE(waitFor([this] { return text("coachTold").contains(QStringLiteral("answered")); }));
}

TEST_F(CoachWindow, ThePointerPullsTheHelmToALevel) {
    pair();
    auto* helm = find<ui::HelmPad>("coachHelm");
    const QPoint middle = helm->rect().center();
    QTest::mousePress(helm, Qt::LeftButton, {}, QPoint(middle.x(), 0));
    EXPECT_TRUE(sends("af05 03 70"));
    QTest::mouseRelease(helm, Qt::LeftButton, {}, middle);
    EXPECT_TRUE(waitFor([this] { return packets.last() == "af05 03 00"; }));
    EXPECT_TRUE(helm->asked().isZero());
}

TEST_F(CoachWindow, TheHelmKeepsItsSizeWhateverIsToldBelowIt) {
    pair();
    auto* helm = find<ui::HelmPad>("coachHelm");
    const auto widthBelow = [&](const char* words) {
        find<QLabel>("coachTold")->setText(QLatin1String(words));
        helm->parentWidget()->layout()->activate();
        return helm->width();
    };
    const int width = widthBelow("Told: stop, answered");
    EXPECT_EQ(widthBelow("Told: 100 % backward, 100 % counterclockwise, not answered yet"), width);
    EXPECT_GT(width, 240) << "it is what everybody looks at";
}

TEST_F(CoachWindow, StopSendsZeroAndHoldsItUntilItIsReArmed) {
    pair();
    auto* helm = find<ui::HelmPad>("coachHelm");
    QTest::keyPress(helm, Qt::Key_Up);
    ASSERT_TRUE(sends("af05 03 70"));
    client->stop(StopReason::Person);
    ASSERT_TRUE(waitFor([this] { return packets.last() == "af05 03 00"; }));
    ASSERT_TRUE(waitFor([helm] { return helm->asked().isZero(); }));
    ASSERT_TRUE(waitFor([this] { return !bench->isMoving(); }));
    client->rearm();
    ASSERT_TRUE(waitFor([this] { return !client->isStopped(); }));
    // What was held through STOP steers nothing, also in the velocities that follow re-arming.
    const TimePoint rearmed = client->now();
    ASSERT_TRUE(
        waitFor([this, rearmed] { return state()->coach.sentAt > rearmed + std::chrono::milliseconds(50); }));
    EXPECT_EQ(packets.last(), "af05 03 00");
    QTest::keyRelease(helm, Qt::Key_Up);
    QTest::keyPress(helm, Qt::Key_Down);
    EXPECT_TRUE(sends("af05 03 f0"));
    QTest::keyRelease(helm, Qt::Key_Down);
}

TEST_F(CoachWindow, TheSticksOfAGamepadSteerAndLettingThemGoStops) {
    pair();
    takeGamepad();
    pads.state.axes[kLeftY] = -1;
    EXPECT_TRUE(sends("af05 03 70"));
    pads.state.axes[kRightX] = 1;
    EXPECT_TRUE(sends("af05 03 7f"));
    pads.state.axes[kLeftY] = 0;
    pads.state.axes[kRightX] = 0;
    EXPECT_TRUE(waitFor([this] { return packets.last() == "af05 03 00"; }));
    // What rests leaves the helm to the keys.
    auto* helm = find<ui::HelmPad>("coachHelm");
    QTest::keyPress(helm, Qt::Key_Down);
    EXPECT_TRUE(sends("af05 03 f0"));
    QTest::keyRelease(helm, Qt::Key_Down);
}

TEST_F(CoachWindow, AGamepadThatIsLostStopsAndMustBeLetGoWhenItIsBack) {
    pair();
    takeGamepad();
    pads.state.axes[kLeftY] = -1;
    ASSERT_TRUE(sends("af05 03 70"));
    pads.plugged.clear();
    ASSERT_TRUE(waitFor([this] { return packets.last() == "af05 03 00"; }));
    EXPECT_TRUE(text("coachPadState").contains(QStringLiteral("gone")));
    pads.plugged = {{2, "Fake pad", "0011", true}};
    ASSERT_TRUE(
        waitFor([this] { return text("coachPadState").contains(QStringLiteral("Let the sticks go")); }));
    EXPECT_TRUE(find<ui::HelmPad>("coachHelm")->asked().isZero());
    pads.state.axes[kLeftY] = 0;
    ASSERT_TRUE(waitFor([this] { return text("coachPadState").contains(QStringLiteral("steers")); }));
    pads.state.axes[kLeftY] = 1;
    EXPECT_TRUE(sends("af05 03 f0"));
}

TEST_F(CoachWindow, TheStopButtonOfAGamepadStopsAndTheStickThatIsHeldCountsForNothing) {
    pair();
    takeGamepad();
    pads.state.axes[kLeftY] = -1;
    ASSERT_TRUE(sends("af05 03 70"));
    pads.state.buttons[kStopButton] = true;
    ASSERT_TRUE(waitFor([this] { return client->isStopped(); }));
    ASSERT_TRUE(waitFor([this] { return packets.last() == "af05 03 00"; }));
    pads.state.buttons[kStopButton] = false;
    client->rearm();
    ASSERT_TRUE(waitFor([this] { return !client->isStopped(); }));
    const TimePoint rearmed = client->now();
    ASSERT_TRUE(
        waitFor([this, rearmed] { return state()->coach.sentAt > rearmed + std::chrono::milliseconds(50); }));
    EXPECT_EQ(packets.last(), "af05 03 00");
    EXPECT_TRUE(text("coachPadState").contains(QStringLiteral("Let the sticks go")));
}

TEST_F(CoachWindow, TheChartsShowOneStateLitAndTheTimersThatRun) {
    pair();
    ASSERT_TRUE(waitFor([this] { return lit("coachChart") == QStringLiteral("paired"); }));
    const ui::Chart& chart = find<ui::ChartView>("coachChart")->chart();
    EXPECT_FALSE(chart.timers.empty());
    for (const ui::ChartArrow& arrow : chart.arrows) {
        EXPECT_LT(arrow.from, chart.states.size());
        EXPECT_LT(arrow.to, chart.states.size());
        EXPECT_NE(arrow.from, arrow.to);
        EXPECT_FALSE(arrow.fires.isEmpty());
    }
    // Each state can be come to and left, but for the first one, which nothing leads back to.
    for (std::size_t one = 0; one < chart.states.size(); ++one) {
        const auto leads = [one](const ui::ChartArrow& arrow) { return arrow.to == one; };
        const auto leaves = [one](const ui::ChartArrow& arrow) { return arrow.from == one; };
        EXPECT_EQ(std::any_of(chart.arrows.begin(), chart.arrows.end(), leads), one != 0);
        EXPECT_TRUE(std::any_of(chart.arrows.begin(), chart.arrows.end(), leaves));
    }
    // Silence and Jettison end a mutiny as they end everything.
    for (const char* from : {"paired", "mutiny (paired)"}) {
        EXPECT_TRUE(std::any_of(chart.arrows.begin(), chart.arrows.end(), [&](const ui::ChartArrow& arrow) {
            return chart.states[arrow.from].name == QLatin1String(from) &&
                   chart.states[arrow.to].name == QStringLiteral("not paired");
        })) << from;
    }
    click("coachMayJettison");
    click("coachJettison");
    ASSERT_TRUE(waitFor([this] { return lit("coachChart") == QStringLiteral("not paired"); }));
}

TEST_F(CoachWindow, SaysThatTheBoatsOwnTimerStopsItWhenTheLineIsLost) {
    pair();
    EXPECT_TRUE(text("coachOwnTimer").contains(QStringLiteral("own timer")));
    bench->submit(SimPerform{"plugged", -1, 0});
    ASSERT_TRUE(waitFor([this] { return state()->link == coach::LinkState::Searching; }));
    ASSERT_TRUE(waitFor([this] { return text("coachEmpty").contains(QStringLiteral("own timer")); }));
}

TEST_F(CoachWindow, ARefusedCommandIsToldInItsPanel) {
    connectTo("sim:coach");
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("coachStart")->isEnabled(); }));
    find<QSpinBox>("coachTeam")->setFocus();
    find<QSpinBox>("coachTeam")->setValue(9);
    click("coachStart");
    EXPECT_TRUE(waitFor([this] { return text("coachNotice").contains(QStringLiteral("COACH 9")); }))
        << text("coachNotice").toStdString();
    click("towrpStart");
    EXPECT_TRUE(waitFor([this] { return text("towrpNotice").contains(QStringLiteral("TOWRP")); }))
        << text("towrpNotice").toStdString();
}

TEST_F(CoachWindow, FreeCommandsGoToTheBoat) {
    pair();
    click("coachDigital");
    EXPECT_TRUE(sends("af05 04 00"));
    find<QSpinBox>("coachPercent")->setValue(-40);
    click("coachAnalog");
    EXPECT_TRUE(sends("af05 05 d8"));
}

TEST_F(CoachWindow, ANamedSeriesOfActionsQuellsAMutiny) {
    pair();
    auto* names = find<QLineEdit>("coachSeries");
    names->setText(QStringLiteral("Rum, Plank"));
    QTest::keyClick(names, Qt::Key_Return);
    ASSERT_TRUE(waitFor([this] { return state()->series.size() == 2; }));
    ASSERT_TRUE(
        waitFor([this] { return window->findChild<QWidget*>(QStringLiteral("coachAction2")) == nullptr; }));
    EXPECT_EQ(find<QAbstractButton>("coachAction0")->text(), QStringLiteral("Rum"));
    EXPECT_FALSE(find<QAbstractButton>("coachAction0")->isEnabled());
    // A mutiny lasts three seconds: a busy machine may need another one.
    while (state()->coach.morale != -5) {
        ASSERT_TRUE(mutiny());
        EXPECT_TRUE(text("coachMutiny").contains(QStringLiteral("MUTINY")));
        find<QAbstractButton>("coachAction0")->click();
        find<QAbstractButton>("coachAction1")->click();
        ASSERT_TRUE(waitFor(
            [this] { return state()->coach.morale == -5 || state()->coach.state != CoachState::Paired; }));
    }
    EXPECT_TRUE(packets.holds("af05 00 00"));
    ASSERT_TRUE(waitFor([this] { return !find<ui::MoraleView>("coachMorale")->ring(); }));
    ASSERT_TRUE(waitFor([this] {
        const std::vector<float>& history = find<ui::MoraleView>("coachMorale")->history();
        return std::find(history.begin(), history.end(), -5.0F) != history.end();
    }));
    EXPECT_EQ(state()->coach.state, CoachState::Paired);
}

TEST_F(CoachWindow, TheSeriesIsRememberedForTheNextConnection) {
    connectTo("sim:coach");
    auto* names = find<QLineEdit>("coachSeries");
    names->setText(QStringLiteral("Rum, Plank"));
    QTest::keyClick(names, Qt::Key_Return);
    ASSERT_TRUE(waitFor([this] { return state()->series.size() == 2; }));
    bench->disconnectAll();
    ASSERT_TRUE(waitFor([this] { return state() == nullptr; }));
    connectTo("sim:coach");
    EXPECT_TRUE(waitFor([this] { return state()->series == std::vector<std::string>{"Rum", "Plank"}; }));
}

TEST_F(CoachWindow, JettisonWantsTwoGesturesAndThenAnotherBoatIsChosen) {
    pair("sim:coach?fall=0&towrps=3,5");
    EXPECT_FALSE(find<QAbstractButton>("coachJettison")->isEnabled());
    click("coachMayJettison");
    click("coachJettison");
    EXPECT_TRUE(sends("af05 02 00"));
    ASSERT_TRUE(waitFor([this] { return state()->coach.state == CoachState::NotPaired; }));
    auto* boats = find<QTableWidget>("coachBoats");
    ASSERT_TRUE(waitFor([boats] { return boats->rowCount() == 2; }));
    EXPECT_FALSE(find<QAbstractButton>("coachPair")->isEnabled());
    EXPECT_FALSE(find<QAbstractButton>("coachMayJettison")->isEnabled());
    boats->selectRow(0);
    EXPECT_EQ(boats->item(0, 0)->text(), QStringLiteral("3"));
    click("coachPair");
    EXPECT_TRUE(sends("af03 01 00"));
    ASSERT_TRUE(waitFor([this] {
        return state()->coach.boat == coach::Team{3} && state()->coach.state == CoachState::Paired;
    }));
}

TEST_F(CoachWindow, ActsAsTheBoatOfASimulatedCoach) {
    connectTo("sim:coach?address=0xAF05&coaches=4&towrps=");
    bench->goTo(QStringLiteral("towrp"));
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("towrpStart")->isEnabled(); }));
    click("towrpStart");
    EXPECT_TRUE(sends("ffff 21 00"));
    ASSERT_TRUE(waitFor([this] { return state()->towrp.state == TowrpState::Paired; }));
    EXPECT_TRUE(sends("ffff 22 04"));
    ASSERT_TRUE(waitFor([this] { return text("towrpVelocity").contains(QStringLiteral("forward")); }));
    find<QSpinBox>("towrpWanted")->setValue(12);
    click("towrpSet");
    EXPECT_TRUE(sends("bc04 23 0c"));
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("towrpMutiny")->isEnabled(); }));
    click("towrpMutiny");
    EXPECT_TRUE(sends("bc04 20 00"));
    // The simulated COACH quells it.
    ASSERT_TRUE(waitFor([this] { return packets.holds("bc04 23 fb"); }));
    click("towrpEnd");
    ASSERT_TRUE(waitFor([this] { return !state()->role; }));
}

TEST_F(CoachWindow, AFreshModuleIsFoundSetAndReadBack) {
    connectTo("sim:coach?fresh=1");
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("radioFind")->isEnabled(); }));
    EXPECT_FALSE(find<QAbstractButton>("radioApply")->isEnabled());
    click("radioFind");
    ASSERT_TRUE(waitFor([this] { return state()->radio.has_value(); }));
    find<QComboBox>("radioPreset")->setCurrentIndex(0);
    find<QSpinBox>("radioNumber")->setValue(7);
    click("radioUse");
    EXPECT_EQ(find<QSpinBox>("radioAddress")->value(), 0xBC07);
    EXPECT_FALSE(text("radioChanges").isEmpty());
    EXPECT_TRUE(text("radioHeld0").contains(QStringLiteral("0x0000"))) << text("radioHeld0").toStdString();
    EXPECT_TRUE(text("radioHeld1").isEmpty());
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("radioApply")->isEnabled(); }));
    click("radioApply");
    ASSERT_TRUE(waitFor([this] { return state()->link == coach::LinkState::Running; }));
    EXPECT_EQ(state()->radio->settings.address, 0xBC07);
    ASSERT_TRUE(waitFor([this] { return text("radioChanges").isEmpty(); }));
    EXPECT_EQ(find<QSpinBox>("coachTeam")->value(), 7);
}

TEST_F(CoachWindow, ABoatThatIsSilentIsNotShownAsAnswering) {
    pair();
    ASSERT_TRUE(waitFor([this] { return text("coachTold").endsWith(QStringLiteral(", answered")); }))
        << text("coachTold").toStdString();
    bench->submit(SimPerform{"boat-loss", 5, 1});
    bool lied = false;
    EXPECT_TRUE(waitFor([&] {
        const Duration silence = state()->time - state()->coach.answeredAt;
        const bool says = text("coachTold").endsWith(QStringLiteral(", answered")) ||
                          text("coachMutiny").contains(QStringLiteral("obeys"));
        lied = lied || (says && silence > std::chrono::milliseconds(1500));
        return state()->coach.state == CoachState::NotPaired;
    }));
    EXPECT_FALSE(lied);
}

TEST_F(CoachWindow, ACrewThatWasNotQuelledIsNotSaidToObey) {
    pair();
    bench->submit(SimPerform{"morale", 5, -10});
    bool lied = false;
    EXPECT_TRUE(waitFor([&] {
        const bool obeys = text("coachMutiny").contains(QStringLiteral("obeys"));
        lied = lied || (obeys && state()->coach.morale == -10 && !state()->coach.mutiny);
        return state()->coach.state == CoachState::NotPaired;
    }));
    EXPECT_FALSE(lied);
}

TEST_F(CoachWindow, APresetForARobotThatThereIsNotIsRefused) {
    connectTo("sim:coach");
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("radioFind")->isEnabled(); }));
    const int address = find<QSpinBox>("radioAddress")->value();
    find<QComboBox>("radioPreset")->setCurrentIndex(4);
    find<QSpinBox>("radioNumber")->setValue(16);
    click("radioUse");
    EXPECT_EQ(find<QSpinBox>("radioAddress")->value(), address);
    EXPECT_TRUE(text("radioNotice").contains(QStringLiteral("0 to 15"))) << text("radioNotice").toStdString();
    find<QSpinBox>("radioNumber")->setValue(15);
    click("radioUse");
    EXPECT_EQ(find<QSpinBox>("radioAddress")->value(), 0x7B2F);
    EXPECT_TRUE(text("radioNotice").isEmpty());
}

TEST_F(CoachWindow, EveryControlHasANameOfItsOwn) {
    connectTo("sim:coach");
    std::set<QString> names;
    for (const char* id : {"coach", "towrp", "radio"}) {
        for (const QWidget* widget : find<ui::PanelDock>(id)->findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const bool control = button != nullptr || qobject_cast<const QSpinBox*>(widget) != nullptr ||
                                 qobject_cast<const QComboBox*>(widget) != nullptr ||
                                 qobject_cast<const ui::HelmPad*>(widget) != nullptr;
            if (!control || !widget->objectName().startsWith(QLatin1String(id))) continue;
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
