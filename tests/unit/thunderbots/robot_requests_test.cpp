#include "core/thunderbots/robot_requests.h"

#include <map>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/thunderbots/wire/dongle.h"
#include "tests/support/session/fake_usb_link.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kOut = wire::address(wire::Endpoint::MessageOut);

class RobotRequestsTest : public ::testing::Test {
  protected:
    RobotRequestsTest() {
        link.finishOpen(UsbDeviceInfo{});
        pipe.open();
        for (int robot = 0; robot < 4; ++robot)
            requests.found(robot);
    }

    RobotRequests::Done keep(int robot) {
        return [this, robot](Result<wire::FirmwareResponse> result) {
            results[robot].push_back(std::move(result));
        };
    }
    void ask(int robot, const wire::FirmwareRequest& request) {
        ASSERT_TRUE(requests.ask(robot, request, keep(robot)));
        scheduler.runPending();
    }
    void askOnce(int robot, const wire::FirmwareRequest& request) {
        ASSERT_TRUE(requests.askOnce(robot, request, keep(robot)));
        scheduler.runPending();
    }
    /// Lets the dongle take everything, and gives what that was.
    std::vector<wire::FirmwareRequest> taken() {
        std::vector<wire::FirmwareRequest> all;
        scheduler.runPending();
        while (!link.pending(kOut).empty()) {
            const ByteView packet = link.pending(kOut).front().data;
            all.push_back(*wire::decodeFirmwareRequest(packet.subspan(1)));
            link.complete(kOut);
            scheduler.runPending();
        }
        return all;
    }
    /// The one request that the dongle takes now.
    wire::FirmwareRequest takenOne() {
        auto all = taken();
        EXPECT_EQ(all.size(), 1U);
        return all.empty() ? wire::FirmwareRequest{} : all.front();
    }
    void respond(int robot, const wire::FirmwareResponse& response) {
        const auto payload = wire::encodeFirmwareResponse(response);
        const auto packet = wire::encodeMessagePacket(static_cast<std::uint8_t>(robot),
                                                      wire::Pipe::FirmwareResponse, payload->view());
        requests.received(packet->view());
        scheduler.runPending();
    }
    /// Takes what is asked for as a sign of life, and gives the answer to it.
    wire::BlockCrcResponse takeSign() {
        const auto request = takenOne();
        const auto* sign = std::get_if<wire::BlockCrcRequest>(&request);
        EXPECT_TRUE(sign);
        return sign ? wire::BlockCrcResponse{sign->address, sign->length, 0x1234} : wire::BlockCrcResponse{};
    }
    void giveSign(int robot) { respond(robot, takeSign()); }
    std::optional<Errc> error(int robot) {
        if (results[robot].size() != 1 || results[robot].front()) return std::nullopt;
        return results[robot].front().error().code;
    }
    bool answered(int robot) { return results[robot].size() == 1 && results[robot].front(); }

    FakeScheduler scheduler;
    kickstand::testing::FakeUsbLink link;
    StopLatch stop;
    MessagePipe pipe{link, scheduler, stop, [](const Error&) {}};
    RobotRequests requests{scheduler, pipe};
    std::map<int, std::vector<Result<wire::FirmwareResponse>>> results;
};

const wire::ReadParametersRequest kRead{};
const wire::CommitParametersRequest kCommit{};
const wire::ProgramPageRequest kProgram{.page = 7, .crc = 0x1234};
const wire::BlockCrcRequest kBlock{.address = 0x10000, .length = 0x8000};

TEST_F(RobotRequestsTest, AsksForASignOfLifeBeforeTheFirstRequest) {
    ask(0, kRead);
    EXPECT_TRUE(requests.state(0).awaitingSign);
    giveSign(0);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kRead});
    wire::ReadParametersResponse response;
    response.parameters.robotNumber = 3;
    respond(0, response);
    ASSERT_TRUE(answered(0));
    EXPECT_EQ(*results[0].front(), wire::FirmwareResponse{response});
    EXPECT_FALSE(requests.busy(0));

    ask(0, kCommit);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kCommit}) << "the link is known to be in order";
}

TEST_F(RobotRequestsTest, HasOneRequestInFlightForEachRobot) {
    ask(0, kRead);
    ask(1, kRead);
    const auto refused = requests.ask(0, kCommit, keep(0));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::RequestPending);
    EXPECT_EQ(taken().size(), 2U) << "robots are independent";
    EXPECT_TRUE(results[0].empty());
}

TEST_F(RobotRequestsTest, RefusesWhatTheEncoderRefusesAndRobotsThatAreNotHeard) {
    EXPECT_EQ(requests.ask(0, wire::BlockCrcRequest{0, 0}, keep(0)).error().code, Errc::OutOfRange);
    EXPECT_EQ(requests.ask(9, kRead, keep(9)).error().code, Errc::RobotNotAlive);
    EXPECT_FALSE(requests.busy(0));
}

TEST_F(RobotRequestsTest, EstablishesTheLinkAfterATimeOutBeforeItAsksAgain) {
    ask(0, kRead);
    giveSign(0);
    takenOne();
    scheduler.advance(3s);
    EXPECT_TRUE(requests.state(0).awaitingSign);
    EXPECT_EQ(requests.state(0).unanswered, 1U);
    const auto sign = takeSign();
    EXPECT_TRUE(taken().empty()) << "nothing else before the sign";
    respond(0, sign);
    EXPECT_EQ(requests.state(0).attempt, 2);
    EXPECT_EQ(requests.state(0).attempts, RequestChannel::kAttempts);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kRead});
    respond(0, wire::ReadParametersResponse{});
    EXPECT_TRUE(answered(0));
    EXPECT_FALSE(requests.state(0).op);
}

TEST_F(RobotRequestsTest, IgnoresALateAnswerUntilTheLinkIsEstablished) {
    ask(0, kCommit);
    giveSign(0);
    takenOne();
    scheduler.advance(3s);
    const auto sign = takeSign();
    respond(0, wire::CommitParametersResponse{});
    EXPECT_TRUE(results[0].empty()) << "it may be the answer to anything";
    respond(0, wire::ReadParametersResponse{});
    respond(0, sign);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kCommit});
}

TEST_F(RobotRequestsTest, AsksWithAnotherAddressEveryTimeTheLinkIsEstablished) {
    ask(0, kRead);
    const auto first = takeSign();
    respond(0, first);
    takenOne();
    scheduler.advance(3s);
    const auto second = takeSign();
    EXPECT_NE(first, second);
    respond(0, first);
    EXPECT_TRUE(taken().empty()) << "the answer to an earlier sign establishes nothing";
    respond(0, second);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kRead});
}

TEST_F(RobotRequestsTest, AnAnswerThatComesBeforeTheDongleHasTheRequestIsNone) {
    ask(0, kCommit);
    giveSign(0);
    // On its way, not taken.
    respond(0, wire::CommitParametersResponse{});
    EXPECT_TRUE(results[0].empty());
    EXPECT_EQ(requests.state(0).strays, 1U);
    takenOne();
    respond(0, wire::CommitParametersResponse{});
    EXPECT_TRUE(results[0].empty()) << "this may be one more of the old ones";
    giveSign(0);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kCommit});
    respond(0, wire::CommitParametersResponse{});
    EXPECT_TRUE(answered(0));
}

TEST_F(RobotRequestsTest, ABlockCrcIsToldByItsAddressAndLengthFromAnyOther) {
    ask(0, kBlock);
    giveSign(0);
    takenOne();
    respond(0, wire::BlockCrcResponse{kBlock.address, kBlock.length / 2, 1});
    respond(0, wire::BlockCrcResponse{kBlock.address + 256, kBlock.length, 2});
    EXPECT_TRUE(results[0].empty());
    respond(0, wire::BlockCrcResponse{kBlock.address, kBlock.length, 3});
    ASSERT_TRUE(answered(0));
    EXPECT_EQ(std::get<wire::BlockCrcResponse>(*results[0].front()).crc, 3);
}

TEST_F(RobotRequestsTest, AResponseThatNobodyWaitsForPutsTheLinkInDoubt) {
    ask(0, kRead);
    giveSign(0);
    takenOne();
    respond(0, wire::ReadParametersResponse{});
    respond(0, wire::ReadParametersResponse{});
    EXPECT_EQ(requests.state(0).strays, 1U);
    ask(0, kCommit);
    giveSign(0);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kCommit});
}

TEST_F(RobotRequestsTest, AnotherRobotsResponseIsNoAnswer) {
    for (const int robot : {0, 1}) {
        ask(robot, kRead);
        giveSign(robot);
        takenOne();
    }
    respond(1, wire::ReadParametersResponse{});
    EXPECT_TRUE(results[0].empty());
    EXPECT_TRUE(answered(1));
}

TEST_F(RobotRequestsTest, DamagedResponsesAreCountedAndAnswerNothing) {
    ask(0, kRead);
    giveSign(0);
    takenOne();
    const std::vector<std::vector<std::uint8_t>> packets{{0x04}, {0x04, 0x04}, {0x04, 0x63}, {}, {0x0F, 4}};
    for (const auto& packet : packets)
        requests.received(packet);
    EXPECT_TRUE(results[0].empty());
    EXPECT_EQ(requests.state(0).strays, 3U);
}

TEST_F(RobotRequestsTest, GivesUpWhatIsNeverAnsweredThoughTheRobotLives) {
    ask(0, kRead);
    for (int attempt = 1; attempt <= RequestChannel::kAttempts; ++attempt) {
        giveSign(0);
        EXPECT_EQ(requests.state(0).attempt, attempt);
        takenOne();
        scheduler.advance(3s);
    }
    EXPECT_TRUE(results[0].empty());
    giveSign(0);
    EXPECT_EQ(error(0), Errc::Unanswered);
    EXPECT_EQ(results[0].front().error().got, RequestChannel::kAttempts);
}

TEST_F(RobotRequestsTest, GivesUpARobotThatGivesNoSign) {
    ask(0, kRead);
    int asked = 0;
    for (; results[0].empty() && asked < 100; ++asked) {
        takeSign();
        scheduler.advance(2s);
    }
    EXPECT_EQ(error(0), Errc::TimedOut);
    EXPECT_EQ(asked, RequestChannel::kSignTries);
}

TEST_F(RobotRequestsTest, WaitsForARobotThatIsStillErasing) {
    ask(0, kRead);
    for (int i = 0; i < 4; ++i) {
        takeSign();
        scheduler.advance(2s);
    }
    respond(0, wire::EraseChipResponse{});
    EXPECT_TRUE(results[0].empty());
    giveSign(0);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kRead});
}

TEST_F(RobotRequestsTest, ProgramsOnceFillsFirst) {
    wire::FillPageRequest fill;
    fill.data.append(std::uint8_t{1});
    ASSERT_TRUE(requests.program(0, {fill, fill}, kProgram, keep(0)));
    giveSign(0);
    const auto sent = taken();
    ASSERT_EQ(sent.size(), 3U);
    EXPECT_EQ(sent[1], wire::FirmwareRequest{fill});
    EXPECT_EQ(sent[2], wire::FirmwareRequest{kProgram});
    scheduler.advance(3s);
    giveSign(0);
    EXPECT_EQ(error(0), Errc::Unanswered) << "what the buffer holds is for the caller to settle";
}

TEST_F(RobotRequestsTest, EndsWithTheReasonWhenTheRobotOrTheLinkIsLost) {
    ask(0, kRead);
    ask(1, kRead);
    requests.lost(0, Errc::RobotNotAlive);
    requests.lost(1, Errc::Disconnected);
    EXPECT_EQ(error(0), Errc::RobotNotAlive);
    EXPECT_EQ(error(1), Errc::Disconnected);
    taken();
    requests.found(0);
    results.clear();
    ask(0, kCommit);
    giveSign(0);
    EXPECT_EQ(takenOne(), wire::FirmwareRequest{kCommit});
}

TEST_F(RobotRequestsTest, ARobotThatIsToldToRebootHasDoneSoWhenItIsLost) {
    ask(0, wire::RebootRequest{});
    EXPECT_FALSE(requests.rebooting(0));
    giveSign(0);
    takenOne();
    EXPECT_TRUE(requests.rebooting(0));
    requests.lost(0, Errc::RobotNotAlive);
    EXPECT_TRUE(answered(0));
    requests.found(0);
    EXPECT_FALSE(requests.rebooting(0));
}

TEST_F(RobotRequestsTest, ALossLongAfterARebootIsASurpriseAgain) {
    ask(0, wire::RebootRequest{});
    giveSign(0);
    takenOne();
    respond(0, wire::RebootResponse{});
    EXPECT_TRUE(requests.rebooting(0));
    scheduler.advance(21s);
    EXPECT_FALSE(requests.rebooting(0));
}

TEST_F(RobotRequestsTest, ARebootThatWasNotSentYetHasNotHappened) {
    ask(0, wire::RebootRequest{});
    requests.lost(0, Errc::RobotNotAlive);
    EXPECT_EQ(error(0), Errc::RobotNotAlive);
}

TEST_F(RobotRequestsTest, CancelsAtOnceAndTakesNothingOldAfterwards) {
    ask(0, wire::EraseChipRequest{});
    giveSign(0);
    takenOne();
    requests.cancel(0);
    EXPECT_EQ(error(0), Errc::Cancelled);
    results.clear();
    ask(0, wire::EraseChipRequest{});
    respond(0, wire::EraseChipResponse{});
    EXPECT_TRUE(results[0].empty()) << "that was the cancelled one";
    requests.cancel(2);
    EXPECT_TRUE(results[2].empty());
}

TEST_F(RobotRequestsTest, EndsWhenTheDongleTakesNothing) {
    ask(0, kRead);
    scheduler.advance(11s);
    EXPECT_EQ(error(0), Errc::TimedOut);
}

TEST_F(RobotRequestsTest, TellsItsListenerWhatWasAnswered) {
    std::vector<int> heard;
    requests.setListener([&heard](int robot, const wire::FirmwareResponse&) { heard.push_back(robot); });
    ask(2, kCommit);
    giveSign(2);
    takenOne();
    respond(2, wire::CommitParametersResponse{});
    respond(2, wire::CommitParametersResponse{});
    EXPECT_EQ(heard, std::vector{2});
}

}  // namespace
}  // namespace kickstand::thunderbots
