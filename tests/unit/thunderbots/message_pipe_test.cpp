#include "core/thunderbots/message_pipe.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/thunderbots/retry.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/dongle.h"
#include "tests/support/session/fake_usb_link.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kOut = wire::address(wire::Endpoint::MessageOut);
/// In the place of an error: the message was taken.
constexpr int kTaken = -1;

class MessagePipeTest : public ::testing::Test {
  protected:
    MessagePipeTest() {
        link.finishOpen(UsbDeviceInfo{});
        pipe.open();
    }

    /// Pushes a message whose first payload byte is `tag`; how it ended is put into results[tag].
    Result<void> push(std::uint8_t tag, wire::Pipe kind, std::optional<Duration> lifetime = std::nullopt) {
        OutMessage message;
        message.robot = tag % kRobots;
        message.pipe = kind;
        message.payload.append(tag);
        if (lifetime) message.expires = scheduler.now() + *lifetime;
        return pipe.push(message, [this, tag](const Result<void>& result) {
            results[tag].push_back(result ? kTaken : static_cast<int>(result.error().code));
        });
    }
    Result<void> pushTest(std::uint8_t tag) { return push(tag, wire::Pipe::TestMode); }
    Result<void> pushKick(std::uint8_t tag) { return push(tag, wire::Pipe::Kick, 200ms); }
    std::uint8_t tagOnItsWay() { return link.pending(kOut).front().data.at(1); }
    static std::vector<int> endedWith(Errc code) { return {static_cast<int>(code)}; }

    FakeScheduler scheduler;
    kickstand::testing::FakeUsbLink link;
    StopLatch stop;
    std::vector<Error> failures;
    std::map<std::uint8_t, std::vector<int>> results;
    MessagePipe pipe{link, scheduler, stop, [this](Error error) { failures.push_back(std::move(error)); }};
};

const std::vector<int> kOnceTaken{kTaken};

TEST_F(MessagePipeTest, SendsMessagesOneAtATimeInTheirOrder) {
    for (std::uint8_t tag = 1; tag <= 4; ++tag)
        ASSERT_TRUE(pushTest(tag));
    for (std::uint8_t tag = 1; tag <= 4; ++tag) {
        ASSERT_EQ(link.pending(kOut).size(), 1U);
        EXPECT_EQ(tagOnItsWay(), tag);
        EXPECT_TRUE(results[tag].empty());
        link.complete(kOut);
        EXPECT_EQ(results[tag], kOnceTaken);
    }
    EXPECT_TRUE(link.pending(kOut).empty());
}

TEST_F(MessagePipeTest, WaitsAsLongAsTheDongleHasNoBufferFree) {
    ASSERT_TRUE(pushTest(1));
    scheduler.advance(1h);
    EXPECT_TRUE(results[1].empty());
    link.complete(kOut);
    EXPECT_EQ(results[1], kOnceTaken);
}

TEST_F(MessagePipeTest, RefusesOneMoreThanMayWait) {
    for (std::size_t i = 0; i < MessagePipe::kCapacity; ++i)
        ASSERT_TRUE(pushTest(1));
    const auto refused = pushTest(2);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::QueueFull);
    EXPECT_TRUE(results[2].empty()) << "refused at once, not answered later as well";
    link.complete(kOut);
    EXPECT_TRUE(pushTest(3));
}

TEST_F(MessagePipeTest, RefusesWhatItCannotEncodeAndWhatComesWhileItIsClosed) {
    EXPECT_EQ(push(1, wire::Pipe::Drive).error().code, Errc::Malformed) << "not a message pipe";
    pipe.close(Error{.code = Errc::Disconnected});
    EXPECT_EQ(pushTest(2).error().code, Errc::NotConnected);
}

TEST_F(MessagePipeTest, DropsAKickThatTheDongleDoesNotTakeWithinItsTime) {
    ASSERT_TRUE(pushKick(1));
    scheduler.advance(200ms - 1ns);
    EXPECT_FALSE(link.pending(kOut).front().cancelAsked);
    scheduler.advance(1ns);
    ASSERT_TRUE(link.pending(kOut).front().cancelAsked);
    EXPECT_TRUE(results[1].empty()) << "nobody knows yet whether it went";
    link.complete(kOut, UsbStatus::Cancelled);
    EXPECT_EQ(results[1], endedWith(Errc::KickExpired));
}

TEST_F(MessagePipeTest, CallsAKickTakenThatWasTakenBeforeTheCancelReachedIt) {
    ASSERT_TRUE(pushKick(1));
    scheduler.advance(200ms);
    link.complete(kOut);
    EXPECT_EQ(results[1], kOnceTaken);
    stop.set(StopReason::Person);
    stop.rearm();
    ASSERT_TRUE(pushKick(2));
    pipe.dropKicks(Errc::StopLatched);
    link.complete(kOut);
    EXPECT_EQ(results[2], kOnceTaken);
}

TEST_F(MessagePipeTest, AnswersAKickThatExpiresBehindAnotherMessageInTime) {
    ASSERT_TRUE(pushTest(1));
    ASSERT_TRUE(pushKick(2));
    scheduler.advance(200ms);
    EXPECT_EQ(results[2], endedWith(Errc::KickExpired));
    EXPECT_FALSE(link.pending(kOut).front().cancelAsked) << "the other message has no such bound";
    link.complete(kOut);
    EXPECT_TRUE(link.pending(kOut).empty());
}

TEST_F(MessagePipeTest, LeavesNoTimerOfADroppedKickBehind) {
    ASSERT_TRUE(pushTest(1));
    ASSERT_TRUE(pushKick(2));
    pipe.dropKicks(Errc::StopLatched);
    ASSERT_TRUE(pushTest(3));
    scheduler.advance(1s);
    EXPECT_FALSE(link.pending(kOut).front().cancelAsked);
    EXPECT_EQ(results[2], endedWith(Errc::StopLatched));
    EXPECT_EQ(scheduler.pending(), 0U);
}

TEST_F(MessagePipeTest, StopDropsKicksAndLeavesTestModes) {
    ASSERT_TRUE(pushKick(1));
    ASSERT_TRUE(pushTest(2));
    ASSERT_TRUE(pushKick(3));
    ASSERT_TRUE(pushTest(4));
    stop.set(StopReason::Person);
    pipe.dropKicks(Errc::StopLatched);
    EXPECT_EQ(results[3], endedWith(Errc::StopLatched));
    ASSERT_TRUE(link.pending(kOut).front().cancelAsked);
    link.complete(kOut, UsbStatus::Cancelled);
    EXPECT_EQ(results[1], endedWith(Errc::StopLatched));
    link.complete(kOut);
    link.complete(kOut);
    EXPECT_EQ(results[2], kOnceTaken);
    EXPECT_EQ(results[4], kOnceTaken);
}

TEST_F(MessagePipeTest, ChecksTheLatchWhenAKickIsSubmittedNotWhenItIsAskedFor) {
    ASSERT_TRUE(pushTest(1));
    ASSERT_TRUE(pushKick(2));
    stop.set(StopReason::Person);
    link.complete(kOut);
    EXPECT_TRUE(link.pending(kOut).empty());
    EXPECT_EQ(results[2], endedWith(Errc::StopLatched));
    ASSERT_TRUE(pushKick(3));
    EXPECT_EQ(results[3], endedWith(Errc::StopLatched));
}

TEST_F(MessagePipeTest, SendsAStalledMessageAgainBecauseItWasNotTaken) {
    ASSERT_TRUE(pushTest(1));
    ASSERT_TRUE(pushTest(2));
    for (int i = 0; i < kStallRetries; ++i) {
        link.complete(kOut, UsbStatus::Stalled);
        ASSERT_EQ(link.clearing().size(), 1U);
        EXPECT_TRUE(link.pending(kOut).empty());
        link.completeClear();
        EXPECT_EQ(tagOnItsWay(), 1);
    }
    link.complete(kOut);
    EXPECT_EQ(results[1], kOnceTaken);
    EXPECT_EQ(tagOnItsWay(), 2);
    EXPECT_TRUE(failures.empty());
}

TEST_F(MessagePipeTest, GivesUpAnEndpointThatStallsAgainAndAgain) {
    ASSERT_TRUE(pushTest(1));
    for (int i = 0; i <= kStallRetries; ++i) {
        link.complete(kOut, UsbStatus::Stalled);
        link.completeClear();
    }
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures.front().endpoint, kOut);
    EXPECT_TRUE(results[1].empty()) << "ended by the close that follows";
    pipe.close(failures.front());
    EXPECT_EQ(results[1], endedWith(Errc::Stalled));
}

TEST_F(MessagePipeTest, StopDropsAKickWhoseEndpointIsBeingCleared) {
    ASSERT_TRUE(pushKick(1));
    link.complete(kOut, UsbStatus::Stalled);
    pipe.dropKicks(Errc::StopLatched);
    EXPECT_EQ(results[1], endedWith(Errc::StopLatched));
    link.completeClear();
    EXPECT_TRUE(link.pending(kOut).empty());
    EXPECT_EQ(results[1].size(), 1U);
}

TEST_F(MessagePipeTest, EndsEveryMessageOnceWhenTheLinkGoes) {
    for (std::uint8_t tag = 1; tag <= 3; ++tag)
        ASSERT_TRUE(pushTest(tag));
    link.unplug();
    pipe.close(Error{.code = Errc::Disconnected});
    for (std::uint8_t tag = 1; tag <= 3; ++tag)
        EXPECT_EQ(results[tag].size(), 1U) << int{tag};
    EXPECT_EQ(results[1], endedWith(Errc::Disconnected));
}

TEST_F(MessagePipeTest, LeavesLateCompletionsOfAnEarlierConnectionAlone) {
    ASSERT_TRUE(pushTest(1));
    pipe.close(Error{.code = Errc::Disconnected});
    pipe.open();
    ASSERT_TRUE(pushTest(2));
    link.complete(kOut);
    EXPECT_EQ(results[1], endedWith(Errc::Disconnected));
    EXPECT_TRUE(results[2].empty());
    link.complete(kOut);
    EXPECT_EQ(results[2], kOnceTaken);
}

}  // namespace
}  // namespace kickstand::thunderbots
