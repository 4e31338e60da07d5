#include "core/thunderbots/state_transport.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/thunderbots/retry.h"
#include "core/thunderbots/wire/dongle.h"
#include "tests/support/session/fake_usb_link.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kOut = wire::address(wire::Endpoint::StateOut);

struct Told {
    int robot = 0;
    wire::DriveBlock block;
    friend bool operator==(const Told&, const Told&) = default;
};

std::vector<Told> toldBy(ByteView packet) {
    std::vector<Told> told;
    wire::MicropacketReader reader(packet, wire::Direction::Out);
    while (const auto next = reader.next()) {
        EXPECT_TRUE(*next);
        if (!*next) return told;
        told.push_back({(*next)->robot, wire::decodeDrive((*next)->payload).value()});
    }
    return told;
}

wire::DriveBlock running(std::int16_t speed) {
    wire::DriveBlock block;
    block.run = true;
    block.wheels = {speed, speed, speed, speed};
    return block;
}

class StateTransportTest : public ::testing::Test {
  protected:
    StateTransportTest() {
        link.finishOpen(UsbDeviceInfo{});
        transport.open();
    }

    std::vector<Told> pending() { return toldBy(link.pending(kOut).front().data); }
    /// Takes everything that is to go.
    void drain() {
        while (!link.pending(kOut).empty())
            link.complete(kOut);
    }
    std::vector<int> robotsOfPending() {
        std::vector<int> robots;
        for (const Told& told : pending())
            robots.push_back(told.robot);
        return robots;
    }

    FakeScheduler scheduler;
    kickstand::testing::FakeUsbLink link;
    StopLatch stop;
    std::vector<Error> failures;
    StateTransport transport{link, scheduler, stop,
                             [this](Error error) { failures.push_back(std::move(error)); }};
};

TEST_F(StateTransportTest, SendsABlockAsSoonAsItIsNews) {
    ASSERT_TRUE(transport.set(3, running(50)));
    ASSERT_EQ(link.pending(kOut).size(), 1U);
    EXPECT_EQ(pending(), (std::vector<Told>{{3, running(50)}}));
    drain();
    ASSERT_TRUE(transport.set(3, running(50)));
    EXPECT_TRUE(link.pending(kOut).empty()) << "what a robot has been told is no news";
}

TEST_F(StateTransportTest, PutsFiveMicropacketsInAPacketAtMost) {
    transport.brakeAll();
    std::vector<std::size_t> sizes;
    std::vector<int> robots;
    while (!link.pending(kOut).empty()) {
        sizes.push_back(pending().size());
        for (const Told& told : pending()) {
            robots.push_back(told.robot);
            EXPECT_EQ(told.block, wire::brakedBlock());
        }
        link.complete(kOut);
    }
    EXPECT_EQ(sizes, (std::vector<std::size_t>{5, 5, 5, 1}));
    EXPECT_EQ(robots, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
}

TEST_F(StateTransportTest, HasOnePacketOnItsWayAtMost) {
    for (int robot = 0; robot < kRobots; ++robot)
        ASSERT_TRUE(transport.set(robot, running(10)));
    EXPECT_EQ(link.pending(kOut).size(), 1U);
}

TEST_F(StateTransportTest, NeverSendsASetPointThatWasReplacedWhileTheDongleRefused) {
    ASSERT_TRUE(transport.set(0, running(1)));
    for (std::int16_t speed = 2; speed <= 50; ++speed)
        ASSERT_TRUE(transport.set(0, running(speed)));
    link.complete(kOut);
    EXPECT_EQ(pending(), (std::vector<Told>{{0, running(50)}}));
    drain();
    EXPECT_EQ(link.taken(kOut).size(), 2U);
}

TEST_F(StateTransportTest, GivesEveryRobotItsTurn) {
    for (const int robot : {7, 8, 9, 10, 11, 12})
        ASSERT_TRUE(transport.set(robot, running(1)));
    // The first five are set anew before every packet: the sixth must not wait for ever.
    bool served = false;
    for (std::int16_t speed = 2; speed < 6 && !served; ++speed) {
        for (const int robot : {7, 8, 9, 10, 11})
            ASSERT_TRUE(transport.set(robot, running(speed)));
        link.complete(kOut);
        for (const int robot : robotsOfPending())
            served = served || robot == 12;
    }
    EXPECT_TRUE(served);
}

TEST_F(StateTransportTest, SendsOnlyBrakedBlocksWhileStopIsLatched) {
    ASSERT_TRUE(transport.set(0, running(100)));
    ASSERT_TRUE(transport.set(1, running(100)));
    stop.set(StopReason::Person);
    link.complete(kOut);
    EXPECT_EQ(pending(), (std::vector<Told>{{1, wire::brakedBlock()}}));
}

TEST_F(StateTransportTest, BrakesAllEvenWhereThatIsNoNews) {
    transport.brakeAll();
    drain();
    transport.brakeAll();
    drain();
    EXPECT_EQ(link.taken(kOut).size(), 8U);
}

TEST_F(StateTransportTest, RefusesABlockThatTheWireHasNoRoomFor) {
    const auto set = transport.set(2, running(1024));
    ASSERT_FALSE(set);
    EXPECT_EQ(set.error().code, Errc::OutOfRange);
    EXPECT_EQ(set.error().robot, 2);
    EXPECT_TRUE(link.pending(kOut).empty());
}

TEST_F(StateTransportTest, KeepsAliveAfterThreeHundredMillisecondsOfSilenceAndNotBefore) {
    ASSERT_TRUE(transport.set(0, running(5)));
    scheduler.advance(20ms);
    link.complete(kOut);
    scheduler.advance(300ms - 1ns);
    EXPECT_FALSE(transport.keepAliveIfDue());
    scheduler.advance(1ns);
    EXPECT_TRUE(transport.keepAliveIfDue());
    ASSERT_EQ(link.pending(kOut).size(), 1U);
    EXPECT_TRUE(link.pending(kOut).front().data.empty());
    scheduler.advance(1s);
    EXPECT_FALSE(transport.keepAliveIfDue()) << "one is on its way";
    link.complete(kOut);
    EXPECT_FALSE(transport.keepAliveIfDue()) << "it has just gone";
}

TEST_F(StateTransportTest, TriesAStalledEndpointAgainWithTheNewestBlockAndThenGivesUp) {
    ASSERT_TRUE(transport.set(0, running(1)));
    ASSERT_TRUE(transport.set(0, running(2)));
    for (int i = 0; i < kStallRetries; ++i) {
        link.complete(kOut, UsbStatus::Stalled);
        ASSERT_EQ(link.clearing(), std::vector<std::uint8_t>{kOut});
        EXPECT_TRUE(link.pending(kOut).empty()) << "nothing goes while the halt is being cleared";
        link.completeClear();
        EXPECT_EQ(pending(), (std::vector<Told>{{0, running(2)}}));
    }
    EXPECT_TRUE(failures.empty());
    link.complete(kOut, UsbStatus::Stalled);
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures.front().code, Errc::Stalled);
    EXPECT_EQ(failures.front().endpoint, kOut);
}

TEST_F(StateTransportTest, CountsStallsInARowOnly) {
    for (int i = 0; i < 3 * kStallRetries; ++i) {
        ASSERT_TRUE(transport.set(0, running(static_cast<std::int16_t>(i + 1))));
        link.complete(kOut, UsbStatus::Stalled);
        link.completeClear();
        link.complete(kOut);
    }
    EXPECT_TRUE(failures.empty());
    EXPECT_EQ(link.taken(kOut).size(), static_cast<std::size_t>(3 * kStallRetries));
}

TEST_F(StateTransportTest, RetriesAStalledKeepAlive) {
    scheduler.advance(300ms);
    ASSERT_TRUE(transport.keepAliveIfDue());
    link.complete(kOut, UsbStatus::Stalled);
    link.completeClear();
    EXPECT_TRUE(transport.keepAliveIfDue()) << "none has gone yet";
}

TEST_F(StateTransportTest, LeavesLateCompletionsOfAnEarlierConnectionAlone) {
    ASSERT_TRUE(transport.set(0, running(1)));
    transport.close();
    transport.open();
    ASSERT_TRUE(transport.set(1, running(2)));
    ASSERT_EQ(link.pending(kOut).size(), 2U);
    link.complete(kOut, UsbStatus::Stalled);
    EXPECT_TRUE(link.clearing().empty());
    ASSERT_TRUE(transport.set(2, running(3)));
    EXPECT_EQ(link.pending(kOut).size(), 1U) << "the packet of this connection is still on its way";
}

TEST_F(StateTransportTest, ForgetsEverySetPointWhenItOpensAgain) {
    ASSERT_TRUE(transport.set(0, running(1)));
    ASSERT_TRUE(transport.set(9, running(1)));
    transport.close();
    link.complete(kOut);
    transport.open();
    EXPECT_TRUE(link.pending(kOut).empty());
    ASSERT_TRUE(transport.set(9, wire::brakedBlock()));
    EXPECT_TRUE(link.pending(kOut).empty()) << "a robot counts as braked when a connection begins";
}

TEST_F(StateTransportTest, TellsEveryoneWhoWaitsThatAllHasBeenTaken) {
    std::vector<int> told;
    transport.brakeAll();
    transport.whenDrained([&told](bool taken) { told.push_back(taken ? 1 : -1); });
    transport.whenDrained([&told](bool taken) { told.push_back(taken ? 2 : -2); });
    for (int i = 0; i < 3; ++i)
        link.complete(kOut);
    EXPECT_TRUE(told.empty());
    link.complete(kOut);
    EXPECT_EQ(told, (std::vector<int>{1, 2}));
    transport.whenDrained([&told](bool taken) { told.push_back(taken ? 3 : -3); });
    EXPECT_EQ(told.back(), 3) << "at once where nothing waits";
}

TEST_F(StateTransportTest, TellsWhoeverWaitsBehindAStalledKeepAlive) {
    scheduler.advance(300ms);
    ASSERT_TRUE(transport.keepAliveIfDue());
    std::vector<bool> told;
    transport.whenDrained([&told](bool taken) { told.push_back(taken); });
    link.complete(kOut, UsbStatus::Stalled);
    EXPECT_TRUE(told.empty());
    link.completeClear();
    EXPECT_EQ(told, std::vector<bool>{true});
}

TEST_F(StateTransportTest, SaysThatBlocksWereNotTakenWhenTheConnectionEnds) {
    std::vector<bool> told;
    transport.brakeAll();
    transport.whenDrained([&told](bool taken) { told.push_back(taken); });
    transport.close();
    EXPECT_EQ(told, std::vector<bool>{false});
    transport.whenDrained([&told](bool taken) { told.push_back(taken); });
    EXPECT_EQ(told, (std::vector<bool>{false, false}));
}

TEST_F(StateTransportTest, DoesNotTakeARefusedSubmissionForASentOne) {
    std::vector<bool> told;
    transport.brakeAll();
    transport.whenDrained([&told](bool taken) { told.push_back(taken); });
    link.refuse();
    link.complete(kOut);
    EXPECT_TRUE(told.empty());
    transport.close();
    EXPECT_EQ(told, std::vector<bool>{false});
}

TEST_F(StateTransportTest, ToleratesAClosingFromInsideOfWhatItTells) {
    std::vector<bool> told;
    transport.brakeAll();
    transport.whenDrained([this](bool) { transport.close(); });
    transport.whenDrained([&told](bool taken) { told.push_back(taken); });
    drain();
    EXPECT_EQ(told, std::vector<bool>{false});
}

}  // namespace
}  // namespace kickstand::thunderbots
