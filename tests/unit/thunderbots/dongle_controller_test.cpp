#include "core/thunderbots/dongle_controller.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "tests/support/session/fake_usb_link.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;
using wire::EStop;
using wire::RadioState;

constexpr std::uint8_t kStatus = wire::address(wire::Endpoint::Status);
constexpr std::uint8_t kStateOut = wire::address(wire::Endpoint::StateOut);

UsbDeviceInfo dongle() {
    UsbDeviceInfo info;
    info.vendor = wire::kVendorId;
    info.product = wire::kDongleProductId;
    return info;
}
UsbDeviceInfo cable() {
    UsbDeviceInfo info = dongle();
    info.product = wire::kCableProductId;
    return info;
}

class DongleControllerTest : public ::testing::Test {
  protected:
    void say(RadioState radios) {
        const auto packet = wire::encodeStatus({EStop::Run, radios, 0});
        link.complete(kStatus, UsbStatus::Completed, packet);
    }
    void drainBlocks() {
        while (!link.pending(kStateOut).empty())
            link.complete(kStateOut);
    }
    /// Brings a dongle up to the point where its radios run.
    void enable() {
        link.finishOpen(dongle());
        link.completeControl();
        link.completeControl();
    }
    void bringUp() {
        enable();
        say(RadioState::Running);
        drainBlocks();
    }
    Errc errorCode() { return controller.error() ? controller.error()->code : Errc::Unsupported; }
    bool asked(const std::string& entry) { return std::ranges::count(link.log(), entry) > 0; }

    FakeScheduler scheduler;
    kickstand::testing::FakeUsbLink link;
    StopLatch stop;
    std::vector<LinkState> states;
    DongleController controller{scheduler, link, stop, [this] { states.push_back(controller.state()); }};
};

TEST_F(DongleControllerTest, StartsADongleInTheOrderOfTheReference) {
    controller.start();
    EXPECT_EQ(link.log(), std::vector<std::string>{"open"}) << "which configures 0, then 1, and claims";
    link.finishOpen(dongle());
    EXPECT_EQ(link.log().back(), "control 40 03 0000") << "enable radios";
    link.completeControl();
    EXPECT_EQ(link.log(),
              (std::vector<std::string>{"open", "control 40 03 0000", "in 81", "control 40 04 0000"}));
    link.completeControl();
    say(RadioState::InitRadio0);
    say(RadioState::InitRadio1);
    EXPECT_EQ(controller.state(), LinkState::Starting);
    EXPECT_FALSE(asked("out 05"));
    say(RadioState::Running);
    EXPECT_EQ(controller.state(), LinkState::Braking);
    link.clearLog();
    for (int packet = 0; packet < 4; ++packet) {
        EXPECT_FALSE(controller.stateTransport().keepAliveIfDue());
        scheduler.advance(400ms);
        ASSERT_EQ(link.pending(kStateOut).size(), 1U);
        EXPECT_FALSE(link.pending(kStateOut).front().data.empty()) << "no keep-alive among the braked blocks";
        for (const char* later : {"in 82", "in 84", "in 85", "in 86"})
            EXPECT_FALSE(asked(later)) << "before the blocks were taken";
        link.complete(kStateOut);
    }
    EXPECT_EQ(controller.state(), LinkState::Running);
    for (const char* endpoint : {"in 82", "in 84", "in 85", "in 86"})
        EXPECT_TRUE(asked(endpoint)) << endpoint;
    EXPECT_FALSE(asked("in 83"));
    EXPECT_TRUE(asked("control c0 01 0000"));
    EXPECT_TRUE(asked("control c0 00 0000"));
    EXPECT_EQ(states, (std::vector<LinkState>{LinkState::Starting, LinkState::Braking, LinkState::Running}));
}

TEST_F(DongleControllerTest, BrakesAllSixteenRobotsBeforeItRuns) {
    controller.start();
    bringUp();
    std::vector<int> braked;
    for (const auto& packet : link.taken(kStateOut)) {
        wire::MicropacketReader reader(packet, wire::Direction::Out);
        while (const auto next = reader.next()) {
            ASSERT_TRUE(*next);
            EXPECT_EQ(wire::decodeDrive((*next)->payload).value(), wire::brakedBlock());
            braked.push_back((*next)->robot);
        }
    }
    EXPECT_EQ(braked, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
}

TEST_F(DongleControllerTest, SetsChannelsBeforeItEnablesTheRadios) {
    controller.start(wire::Channels{0x0B, 0x1A});
    link.finishOpen(dongle());
    EXPECT_EQ(link.log().back(), "control 40 02 1a0b");
    link.completeControl();
    EXPECT_EQ(link.log().back(), "control 40 03 0000");
}

TEST_F(DongleControllerTest, SaysThatChannelsAreLockedWhenTheDongleRefusesThem) {
    controller.start(wire::Channels{0x0B, 0x1A});
    link.finishOpen(dongle());
    link.completeControl(UsbStatus::Stalled);
    EXPECT_EQ(controller.state(), LinkState::Failed);
    EXPECT_EQ(errorCode(), Errc::ChannelsLocked);
    EXPECT_EQ(link.log().back(), "close");
}

TEST_F(DongleControllerTest, NamesTheRadioThatFailed) {
    for (const int radio : {0, 1}) {
        controller.start();
        enable();
        say(radio == 0 ? RadioState::Radio0Failed : RadioState::Radio1Failed);
        EXPECT_EQ(controller.state(), LinkState::Failed);
        EXPECT_EQ(errorCode(), Errc::RadioFailed);
        EXPECT_EQ(controller.error()->got, radio);
        link.finishClose();
        controller.close([] {});
        link.finishClose();
    }
}

TEST_F(DongleControllerTest, FailsWhenARadioBreaksDownWhileItRuns) {
    controller.start();
    bringUp();
    say(RadioState::Radio1Failed);
    EXPECT_EQ(controller.state(), LinkState::Braking) << "robots are braked before the link is given up";
    drainBlocks();
    EXPECT_EQ(controller.state(), LinkState::Failed);
    EXPECT_EQ(controller.error()->got, 1);
}

TEST_F(DongleControllerTest, GivesUpADongleThatIsNotReadyWithinTenSeconds) {
    controller.start();
    enable();
    say(RadioState::InitRadio0);
    scheduler.advance(10s - 1ms);
    EXPECT_EQ(controller.state(), LinkState::Starting);
    scheduler.advance(1ms);
    EXPECT_EQ(controller.state(), LinkState::Failed);
    EXPECT_EQ(errorCode(), Errc::TimedOut);
}

TEST_F(DongleControllerTest, GivesUpADongleThatTakesNoBrakedBlocks) {
    controller.start();
    enable();
    say(RadioState::Running);
    scheduler.advance(10s);
    EXPECT_EQ(errorCode(), Errc::TimedOut);
    link.finishClose();
    EXPECT_EQ(controller.state(), LinkState::Failed);
}

TEST_F(DongleControllerTest, HasNoDeadlineOnceItRuns) {
    controller.start();
    bringUp();
    EXPECT_EQ(scheduler.pending(), 0U);
    scheduler.advance(1h);
    EXPECT_EQ(controller.state(), LinkState::Running);
}

TEST_F(DongleControllerTest, FailsWhenTheDongleRefusesItsRadios) {
    controller.start();
    link.finishOpen(dongle());
    link.completeControl(UsbStatus::TimedOut);
    EXPECT_EQ(controller.state(), LinkState::Failed);
    EXPECT_EQ(errorCode(), Errc::RadioFailed);
}

TEST_F(DongleControllerTest, IgnoresAStatusThatMakesNoSense) {
    controller.start();
    enable();
    const std::vector<std::uint8_t> nonsense{9, 9, 9, 9};
    const std::vector<std::uint8_t> tooShort{3};
    link.complete(kStatus, UsbStatus::Completed, nonsense);
    link.complete(kStatus, UsbStatus::Completed, tooShort);
    EXPECT_EQ(controller.state(), LinkState::Starting);
    say(RadioState::Running);
    EXPECT_EQ(controller.state(), LinkState::Braking);
}

TEST_F(DongleControllerTest, WaitsForADeviceAndStartsItWhenItAppears) {
    controller.start();
    link.finishOpen(fail(Errc::NoDevice));
    EXPECT_EQ(controller.state(), LinkState::Searching);
    EXPECT_FALSE(controller.error());
    scheduler.advance(1h);
    EXPECT_EQ(std::ranges::count(link.log(), "open"), 1) << "it waits to be told";
    link.appear();
    bringUp();
    EXPECT_EQ(controller.state(), LinkState::Running);
}

TEST_F(DongleControllerTest, ResumesAfterAReplugWithoutBeingAsked) {
    controller.start();
    bringUp();
    link.unplug();
    EXPECT_EQ(controller.state(), LinkState::Searching);
    link.appear();
    bringUp();
    EXPECT_EQ(controller.state(), LinkState::Running);
    EXPECT_EQ(link.taken(kStateOut).size(), 8U) << "braked anew";
}

TEST_F(DongleControllerTest, TriesAgainWhatMayMendItselfAndSaysWhyMeanwhile) {
    for (const Errc code : {Errc::PermissionDenied, Errc::ClaimedElsewhere, Errc::SeveralDevices, Errc::Io}) {
        controller.start();
        link.clearLog();
        for (int i = 0; i < 3; ++i) {
            link.finishOpen(fail(code));
            EXPECT_EQ(controller.state(), LinkState::Failed);
            EXPECT_EQ(errorCode(), code);
            scheduler.advance(1s - 1ms);
            EXPECT_FALSE(link.openAsked());
            scheduler.advance(1ms);
            EXPECT_TRUE(link.openAsked());
            EXPECT_EQ(errorCode(), code) << "known until something better is";
        }
        bringUp();
        EXPECT_EQ(controller.state(), LinkState::Running);
        EXPECT_FALSE(controller.error());
        controller.close([] {});
        link.finishClose();
    }
}

TEST_F(DongleControllerTest, NeverOpensTheLinkTwiceAtOnce) {
    controller.start();
    link.finishOpen(fail(Errc::PermissionDenied));
    scheduler.advance(1s);
    link.appear();
    EXPECT_FALSE(asked("open while opening"));
    bringUp();
    EXPECT_EQ(controller.state(), LinkState::Running);
}

TEST_F(DongleControllerTest, LooksAgainForADeviceThatAppearedWhileTheLinkWasOpening) {
    controller.start();
    link.appear();
    link.finishOpen(fail(Errc::NoDevice));
    ASSERT_TRUE(link.openAsked());
    bringUp();
    EXPECT_EQ(controller.state(), LinkState::Running);
}

TEST_F(DongleControllerTest, GivesUpOnAnEndpointThatOnlyStalls) {
    controller.start();
    bringUp();
    const std::uint8_t endpoint = wire::address(wire::Endpoint::StateIn);
    for (int i = 0; i < 20 && controller.state() == LinkState::Running; ++i) {
        link.complete(endpoint, UsbStatus::Stalled);
        link.completeClear();
    }
    EXPECT_EQ(controller.state(), LinkState::Braking);
    drainBlocks();
    EXPECT_EQ(controller.state(), LinkState::Failed);
    EXPECT_EQ(errorCode(), Errc::Stalled);
    EXPECT_EQ(controller.error()->endpoint, endpoint);
}

TEST_F(DongleControllerTest, GivesUpAllTheSameWhenTheLastBlocksDoNotGo) {
    controller.start();
    bringUp();
    say(RadioState::Radio0Failed);
    EXPECT_EQ(controller.state(), LinkState::Braking);
    scheduler.advance(1s);
    EXPECT_EQ(controller.state(), LinkState::Failed);
}

TEST_F(DongleControllerTest, StartsACableWithoutRadios) {
    controller.start();
    link.finishOpen(cable());
    EXPECT_TRUE(controller.isCable());
    EXPECT_FALSE(asked("control 40 03 0000"));
    link.completeControl(UsbStatus::Stalled);
    EXPECT_EQ(controller.state(), LinkState::Starting) << "a cable need not know that request";
    say(RadioState::Running);
    drainBlocks();
    EXPECT_EQ(controller.state(), LinkState::Running);
    EXPECT_FALSE(asked("control c0 01 0000"));
}

TEST_F(DongleControllerTest, ClosesAndStaysClosed) {
    controller.start();
    bringUp();
    bool closed = false;
    controller.close([&closed] { closed = true; });
    EXPECT_EQ(controller.state(), LinkState::Idle);
    link.finishClose();
    EXPECT_TRUE(closed);
    link.appear();
    scheduler.advance(1h);
    EXPECT_EQ(std::ranges::count(link.log(), "open"), 1);
}

TEST_F(DongleControllerTest, TakesNoNoticeOfAnAnswerThatComesAfterTheClose) {
    controller.start();
    controller.close([] {});
    link.finishClose();
    EXPECT_EQ(controller.state(), LinkState::Idle);
    EXPECT_TRUE(states.empty());
}

TEST_F(DongleControllerTest, StaysClosedWhenItIsClosedFromInsideALoss) {
    controller.start();
    bringUp();
    controller.stateTransport().brakeAll();
    controller.stateTransport().whenDrained([this](bool) { controller.close([] {}); });
    link.unplug();
    EXPECT_EQ(controller.state(), LinkState::Idle);
    link.finishClose();
    link.appear();
    EXPECT_FALSE(link.openAsked());
}

TEST_F(DongleControllerTest, LeavesNoTimerBehind) {
    {
        kickstand::testing::FakeUsbLink other;
        DongleController shortLived(scheduler, other, stop, [] {});
        shortLived.start();
        other.finishOpen(fail(Errc::PermissionDenied));
        EXPECT_GT(scheduler.pending(), 0U);
    }
    EXPECT_EQ(scheduler.pending(), 0U);
}

}  // namespace
}  // namespace kickstand::thunderbots
