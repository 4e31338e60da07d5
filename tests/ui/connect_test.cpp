// Connecting: the start page, the Connect menu, links by hand, and leaving again.

#include <QAbstractButton>
#include <QInputDialog>
#include <QMenu>
#include <QTest>

#include "tests/ui/bench_rig.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/state_label.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

class ConnectTest : public testing::Test {
  protected:
    QMenu* openMenu() {
        auto* menu = rig.find<QMenu>(QStringLiteral("connectMenu"));
        menu->popup(QPoint(0, 0));
        return menu;
    }
    /// Chooses an entry as a person would. False where there is none that can be chosen.
    bool choose(const QString& text) {
        QMenu* menu = openMenu();
        QAction* found = nullptr;
        for (QAction* action : menu->actions()) {
            if (action->text().remove(u'&').contains(text) && action->isEnabled()) found = action;
        }
        menu->close();
        if (found != nullptr) found->trigger();
        return found != nullptr;
    }
    bool waitForRunning() {
        return rig.waitForSnapshot(
            [](const Snapshot& snapshot) { return snapshot.link == LinkState::Running; });
    }
    ui::Banner* simulated() { return rig.find<ui::Banner>(QStringLiteral("simulatedBanner")); }
    ui::Banner* problem() { return rig.find<ui::Banner>(QStringLiteral("problemBanner")); }

    static FoundDevice dongle(std::optional<Errc> obstacle = {}) {
        FoundDevice found;
        found.uri.scheme = "usb";
        found.info.vendor = 0x04D8;
        found.info.product = 0x7839;
        found.info.port = "1-2.3";
        found.info.productName = "Thunderbots XBee Dongle";
        if (obstacle) {
            Error error;
            error.code = *obstacle;
            found.obstacle = error;
        }
        return found;
    }

    BenchRig rig;
};

TEST_F(ConnectTest, WithoutHardwareSimulatedRobotsAreOfferedAndNotTaken) {
    ASSERT_TRUE(waitUntil([this] { return rig.client().snapshot().discovered; }));
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(rig.find<QWidget>(QStringLiteral("startPage"))->isVisible());
    EXPECT_TRUE(rig.board().openedLinks().empty());
    EXPECT_FALSE(simulated()->isVisible());
    rig.click(QStringLiteral("simulate"));
    ASSERT_TRUE(waitForRunning());
    EXPECT_FALSE(rig.find<QWidget>(QStringLiteral("startPage"))->isVisible());
    EXPECT_EQ(rig.board().openedLinks(), std::vector<std::string>{"sim:thunderbots"});
}

TEST_F(ConnectTest, ASimulatedLinkSaysSoAllTheTime) {
    rig.click(QStringLiteral("simulate"));
    ASSERT_TRUE(waitForRunning());
    EXPECT_TRUE(simulated()->isVisible());
    EXPECT_TRUE(simulated()->text().startsWith(QStringLiteral("SIMULATED")));
    EXPECT_TRUE(simulated()->text().contains(QStringLiteral("sixteen")));
}

TEST_F(ConnectTest, HardwareIsShownWithoutTheBanner) {
    rig.board().setFound({dongle()});
    rig.window().connector().lookAgain();
    ASSERT_TRUE(waitUntil([this] { return !rig.client().snapshot().found.empty(); }));
    ASSERT_TRUE(choose(QStringLiteral("Thunderbots XBee Dongle")));
    ASSERT_TRUE(waitForRunning());
    EXPECT_FALSE(simulated()->isVisible());
    EXPECT_EQ(rig.board().openedLinks(), std::vector<std::string>{"usb:"});
    EXPECT_TRUE(
        rig.find<ui::StateLabel>(QStringLiteral("state0"))->text().contains(QStringLiteral("Dongle")));
}

TEST_F(ConnectTest, TheOnlyHardwareThereIsIsConnectedAtTheStart) {
    rig.board().setFound({dongle()});
    rig.window().connector().lookAgain();
    ASSERT_TRUE(waitUntil([this] { return !rig.client().snapshot().found.empty(); }));
    rig.window().connector().connectToOnlyHardware();
    ASSERT_TRUE(waitForRunning());
    EXPECT_EQ(rig.board().openedLinks(), std::vector<std::string>{"usb:"});
}

TEST_F(ConnectTest, TwoDevicesAreLeftToAPerson) {
    rig.board().setFound({dongle(), dongle()});
    rig.window().connector().lookAgain();
    ASSERT_TRUE(waitUntil([this] { return rig.client().snapshot().found.size() == 2; }));
    rig.window().connector().connectToOnlyHardware();
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(rig.board().openedLinks().empty());
}

TEST_F(ConnectTest, ADeviceThatMayNotBeOpenedSaysWhatToDo) {
    rig.board().setFound({dongle(Errc::PermissionDenied)});
    rig.window().connector().lookAgain();
    ASSERT_TRUE(waitUntil([this] { return !rig.client().snapshot().found.empty(); }));
    ASSERT_TRUE(choose(QStringLiteral("cannot be opened")));
    EXPECT_TRUE(problem()->isVisible());
    EXPECT_TRUE(problem()->text().endsWith(QStringLiteral("Install the udev rule: copy the command.")))
        << problem()->text().toStdString();
    EXPECT_TRUE(rig.find<QAbstractButton>(QStringLiteral("copyRemedy"))->isVisible());
    EXPECT_TRUE(rig.board().openedLinks().empty());
}

TEST_F(ConnectTest, EveryOfferOfTheMenuOpensItsLink) {
    ASSERT_TRUE(choose(QStringLiteral("5 %")));
    ASSERT_TRUE(waitForRunning());
    ASSERT_TRUE(choose(QStringLiteral("on a cable")));
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& s) { return s.cable && s.link == LinkState::Running; }));
    ASSERT_TRUE(choose(QStringLiteral("Sixteen simulated")));
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& s) { return !s.cable && s.link == LinkState::Running; }));
    EXPECT_EQ(rig.board().openedLinks(),
              (std::vector<std::string>{"sim:thunderbots?loss=0.05", "sim:thunderbots?cable=3",
                                        "sim:thunderbots"}));
    // One at a time: what was connected before has been let go.
    ASSERT_TRUE(waitUntil([this] { return rig.client().snapshot().sessions.size() == 1; }));
}

TEST_F(ConnectTest, ALinkCanBeTypedAndIsRemembered) {
    ASSERT_TRUE(choose(QStringLiteral("Enter link")));
    auto* dialog = rig.find<QInputDialog>(QStringLiteral("linkDialog"));
    dialog->setTextValue(QStringLiteral("sim:thunderbots?robots=7"));
    dialog->accept();
    ASSERT_TRUE(waitForRunning());
    EXPECT_EQ(rig.board().openedLinks(), std::vector<std::string>{"sim:thunderbots?robots=7"});
    EXPECT_EQ(rig.settings().value(QStringLiteral("links/recent")).toStringList().first(),
              QStringLiteral("sim:thunderbots?robots=7"));
}

TEST_F(ConnectTest, ALinkThatMakesNoSenseIsExplained) {
    rig.window().connector().askForLink();
    auto* dialog = rig.find<QInputDialog>(QStringLiteral("linkDialog"));
    dialog->setTextValue(QStringLiteral("nonsense"));
    dialog->accept();
    EXPECT_TRUE(problem()->isVisible());
    EXPECT_TRUE(rig.board().openedLinks().empty());
}

TEST_F(ConnectTest, ALinkThatCannotBeMadeIsExplainedAndTheStartPageStays) {
    const Result<LinkUri> uri = parseLinkUri("sim:thunderbots?robots=99");
    ASSERT_TRUE(uri.has_value());
    rig.window().connector().connectTo(*uri);
    ASSERT_TRUE(waitUntil([this] { return problem()->isVisible(); }));
    EXPECT_TRUE(problem()->text().contains(QStringLiteral("robots")));
    EXPECT_TRUE(rig.find<QWidget>(QStringLiteral("startPage"))->isVisible());
}

TEST_F(ConnectTest, DisconnectingLeadsBackToTheStart) {
    ASSERT_TRUE(rig.connectTo());
    ASSERT_TRUE(choose(QStringLiteral("Disconnect")));
    ASSERT_TRUE(waitUntil([this] { return rig.bench().session() == nullptr; }));
    EXPECT_TRUE(rig.find<QWidget>(QStringLiteral("startPage"))->isVisible());
    EXPECT_FALSE(simulated()->isVisible());
    // The last that was said to every robot is: brake.
    EXPECT_TRUE(
        rig.waitForBlock(0, [](const wire::DriveBlock& block) { return block == wire::brakedBlock(); }));
}

TEST_F(ConnectTest, HardwareThatIsLeftLiveIsRememberedUntilAPersonSaysOtherwise) {
    ASSERT_TRUE(rig.connectTo("usb:"));
    rig.simulate("capacitor", 3, 212);
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& s) { return s.robots[3].readings.capacitor_V > 200; }));
    ASSERT_TRUE(choose(QStringLiteral("Disconnect")));
    ASSERT_TRUE(waitUntil([this] { return rig.bench().session() == nullptr; }));
    auto* banner = rig.find<ui::Banner>(QStringLiteral("leftBehindBanner"));
    EXPECT_TRUE(banner->isVisible());
    EXPECT_TRUE(banner->text().contains(QStringLiteral("robot 3")));
    EXPECT_TRUE(banner->text().contains(QStringLiteral("treat as live")));
    rig.click(QStringLiteral("discharged"));
    EXPECT_FALSE(banner->isVisible());
}

TEST_F(ConnectTest, SimulatedRobotsLeaveNothingBehind) {
    ASSERT_TRUE(rig.connectTo());
    rig.simulate("capacitor", 3, 212);
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& s) { return s.robots[3].readings.capacitor_V > 200; }));
    ASSERT_TRUE(choose(QStringLiteral("Disconnect")));
    ASSERT_TRUE(waitUntil([this] { return rig.bench().session() == nullptr; }));
    EXPECT_TRUE(rig.bench().leftBehind().empty());
}

TEST_F(ConnectTest, WithHardwareBesideItTheBannerSaysThat) {
    ASSERT_TRUE(rig.connectTo("usb:"));
    const Result<LinkUri> simulation = parseLinkUri("sim:thunderbots?robots=0");
    rig.window().connector().connectBeside(*simulation);
    ASSERT_TRUE(waitUntil([this] { return simulated()->isVisible(); }));
    EXPECT_TRUE(simulated()->text().contains(QStringLiteral("HARDWARE IS CONNECTED")));
    EXPECT_EQ(rig.settings().value(QStringLiteral("links/recent")).toStringList().first(),
              QStringLiteral("sim:thunderbots?robots=0"));
    // And back to the other one, by the menu.
    ASSERT_TRUE(choose(QStringLiteral("usb:")));
    EXPECT_FALSE(simulated()->isVisible());
}

TEST_F(ConnectTest, AfterAReplugEverythingStandsAtZero) {
    ASSERT_TRUE(rig.connectTo());
    rig.clickRobot(2);
    rig.typeWheel(1, QStringLiteral("30"));
    ASSERT_TRUE(rig.waitForBlock(2, [](const wire::DriveBlock& block) { return block.wheels[0] == 30; }));
    rig.simulate("plugged", -1, 0);
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.link == LinkState::Searching; }));
    EXPECT_TRUE(rig.client().isStopped());
    rig.wire().clear();
    rig.simulate("plugged", -1, 1);
    ASSERT_TRUE(waitForRunning());
    for (const auto& block : rig.wire().blocks(2))
        EXPECT_EQ(block, wire::brakedBlock());
    EXPECT_TRUE(rig.client().isStopped());
}

}  // namespace
}  // namespace kickstand::test
