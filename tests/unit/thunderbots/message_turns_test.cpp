#include "core/thunderbots/message_turns.h"

#include <string>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/thunderbots/wire/dongle.h"
#include "tests/support/session/fake_usb_link.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kOut = wire::address(wire::Endpoint::MessageOut);

class MessageTurnsTest : public ::testing::Test {
  protected:
    MessageTurnsTest() {
        link.finishOpen(UsbDeviceInfo{});
        pipe.open();
    }

    void push(int robot, int count) {
        std::vector<wire::MessagePayload> messages(static_cast<std::size_t>(count));
        for (wire::MessagePayload& message : messages)
            message.append(std::uint8_t{0});
        turns.push(robot, messages, [this, robot](const Result<void>& result) {
            ended += std::to_string(robot) + (result ? "+" : "-");
        });
        scheduler.runPending();
    }
    /// Lets the dongle take messages, each after that time, and gives the robots they were for.
    std::string taken(Duration each, int most = 100) {
        std::string robots;
        for (; most > 0 && !link.pending(kOut).empty(); --most) {
            scheduler.advance(each);
            robots += std::to_string(wire::robotOfHeader(link.pending(kOut).front().data.at(0)));
            link.complete(kOut);
            scheduler.runPending();
        }
        return robots;
    }

    FakeScheduler scheduler;
    kickstand::testing::FakeUsbLink link;
    StopLatch stop;
    MessagePipe pipe{link, scheduler, stop, [](const Error&) {}};
    MessageTurns turns{scheduler, pipe};
    std::string ended;
};

TEST_F(MessageTurnsTest, SendsARobotsMessagesInOnePieceWhileTheDongleTakesThemPromptly) {
    push(1, 3);
    push(2, 3);
    push(3, 2);
    EXPECT_EQ(taken(1ms), "11122233");
    EXPECT_EQ(ended, "1+2+3+");
}

TEST_F(MessageTurnsTest, LetsRobotsTakeTurnsWhereTheDongleLetsMessagesWait) {
    push(1, 3);
    push(2, 3);
    push(3, 2);
    EXPECT_EQ(taken(6ms), "12312312");
    EXPECT_EQ(ended, "3+1+2+");
}

TEST_F(MessageTurnsTest, HandsOverOneMessageAtATimeSoThatOthersNeedNotWait) {
    push(1, 60);
    EXPECT_EQ(pipe.waiting(), 1U);
    OutMessage kick;
    kick.robot = 9;
    kick.pipe = wire::Pipe::Kick;
    ASSERT_TRUE(pipe.push(kick, [](const Result<void>&) {}));
    EXPECT_EQ(taken(1ms, 3), "191");
}

TEST_F(MessageTurnsTest, NeverLeavesThePipeIdleBetweenTwoMessages) {
    push(1, 3);
    link.complete(kOut);
    EXPECT_EQ(link.pending(kOut).size(), 1U) << "before time passes or anything else runs";
}

TEST_F(MessageTurnsTest, EndsABatchWithTheFirstErrorAndGoesOnWithOthers) {
    push(1, 3);
    push(2, 1);
    link.complete(kOut, UsbStatus::Failed);
    scheduler.runPending();
    EXPECT_EQ(ended, "1-");
    EXPECT_EQ(taken(1ms), "2");
    EXPECT_EQ(ended, "1-2+");
}

TEST_F(MessageTurnsTest, ForgetsWhatIsDropped) {
    push(1, 3);
    push(2, 1);
    turns.drop(1);
    EXPECT_EQ(taken(1ms), "12") << "the first of robot 1 had gone already";
    EXPECT_EQ(ended, "2+");
    push(1, 1);
    EXPECT_EQ(taken(1ms), "1");
    EXPECT_EQ(ended, "2+1+");
}

TEST_F(MessageTurnsTest, EndsEveryBatchWhenThePipeIsClosed) {
    for (int robot = 0; robot < kRobots; ++robot)
        push(robot, 2);
    pipe.close(Error{.code = Errc::Disconnected});
    scheduler.runPending();
    EXPECT_EQ(ended, "0-1-2-3-4-5-6-7-8-9-10-11-12-13-14-15-");
}

}  // namespace
}  // namespace kickstand::thunderbots
