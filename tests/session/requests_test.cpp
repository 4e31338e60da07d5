// Firmware requests over a real start-up, dongle and radio, simulated, on which things go wrong.

#include <random>

#include <gtest/gtest.h>

#include "core/framing/crc16.h"
#include "tests/support/session/request_rig.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;
using kickstand::testing::MessageFate;
using kickstand::testing::PassingMessage;
using kickstand::testing::RequestRig;
using wire::Direction;

sim::ThunderbotsSimOptions quiet() {
    sim::ThunderbotsSimOptions options;
    options.robots = 0x0003;
    options.pace = sim::RadioPace::Ideal;
    options.noise = false;
    return options;
}

wire::OperationalParameters parametersOf(const Result<wire::FirmwareResponse>& answer) {
    return std::get<wire::ReadParametersResponse>(answer.value()).parameters;
}

/// Asks until there is an answer: with enough bad luck a request is given up, which is no wrong answer.
Result<wire::FirmwareResponse> askFirmly(RequestRig& rig, const wire::FirmwareRequest& request) {
    for (int i = 0; i < 5; ++i) {
        auto answer = rig.ask(1, request);
        if (answer || answer.error().code != Errc::Unanswered) return answer;
    }
    return fail(Errc::Unanswered);
}

/// Sets, reads and compares again and again: an answer that was taken for another one's would show.
void converse(RequestRig& rig, int rounds) {
    const auto first = askFirmly(rig, wire::ReadParametersRequest{});
    ASSERT_TRUE(first) << name(first.error().code);
    wire::OperationalParameters wanted = parametersOf(first);
    for (int round = 0; round < rounds; ++round) {
        wanted.dribblerDuty = static_cast<std::uint8_t>(round + 1);
        const auto set = askFirmly(rig, wire::SetParametersRequest{wanted});
        ASSERT_TRUE(set) << name(set.error().code) << " in round " << round;
        const auto read = askFirmly(rig, wire::ReadParametersRequest{});
        ASSERT_TRUE(read) << name(read.error().code) << " in round " << round;
        ASSERT_EQ(parametersOf(read), wanted) << "in round " << round;
        const auto length = static_cast<std::uint32_t>(256 * (round + 1));
        const auto crc = askFirmly(rig, wire::BlockCrcRequest{0x40000, length});
        ASSERT_TRUE(crc) << name(crc.error().code) << " in round " << round;
        ASSERT_EQ(std::get<wire::BlockCrcResponse>(*crc).crc, crc16Fill(0xFF, length));
    }
}

TEST(Requests, AreAnswered) {
    RequestRig rig(quiet());
    ASSERT_TRUE(rig.connect());
    converse(rig, 20);
    EXPECT_EQ(rig.requests.state(1).unanswered, 0U);
    EXPECT_EQ(rig.requests.state(1).strays, 0U);
}

/// Each message is lost, doubled, late or comes once more later, by chance.
class BadLuck : public ::testing::TestWithParam<unsigned> {};

TEST_P(BadLuck, NeverTurnsAnOldAnswerIntoANewOne) {
    std::mt19937 random(GetParam());
    RequestRig rig(quiet(), [&random](const PassingMessage&) {
        MessageFate fate;
        switch (random() % 12) {
            case 0:
                fate.copies = 0;
                break;
            case 1:
                fate.copies = 2;
                break;
            case 2:
                fate.delay = std::chrono::milliseconds(random() % 4000);
                break;
            default:
                break;
        }
        return fate;
    });
    ASSERT_TRUE(rig.connect());
    converse(rig, 25);
    EXPECT_GT(rig.requests.state(1).unanswered, 0U);
    EXPECT_GT(rig.requests.state(1).strays, 0U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BadLuck, ::testing::Range(1U, 21U));

TEST(Requests, WorkOnALossyRadioAtItsTruePace) {
    auto options = quiet();
    options.pace = sim::RadioPace::True;
    options.weather = {.loss = 0.2, .duplication = 0.2, .delay = 10ms};
    RequestRig rig(options);
    ASSERT_TRUE(rig.connect());
    converse(rig, 10);
}

TEST(Requests, WaitForARobotThatAnEarlierRunLeftErasing) {
    RequestRig rig(quiet());
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(1, wire::ReadParametersRequest{}));
    ASSERT_TRUE(rig.requests.askOnce(1, wire::EraseChipRequest{}, [](const auto&) {}));
    rig.scheduler.advance(100ms);
    rig.requests.cancel(1);
    const TimePoint begun = rig.scheduler.now();
    const auto read = rig.ask(1, wire::ReadParametersRequest{});
    ASSERT_TRUE(read) << name(read.error().code);
    EXPECT_GT(rig.scheduler.now() - begun, 7s);
    EXPECT_EQ(parametersOf(read).flash(), wire::FlashContents::NoData);
}

TEST(Requests, EndWhenTheRobotIsLostOrUnplugged) {
    RequestRig rig(quiet());
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.sim.control().perform("dead", 1, 1));
    const auto dead = rig.ask(1, wire::ReadSignaturesRequest{});
    ASSERT_FALSE(dead);
    EXPECT_EQ(dead.error().code, Errc::RobotNotAlive);
    rig.scheduler.callAfter(1s, [&rig] { static_cast<void>(rig.sim.control().perform("plugged", -1, 0)); });
    const auto unplugged = rig.ask(0, wire::ReadSignaturesRequest{});
    ASSERT_FALSE(unplugged);
    EXPECT_EQ(unplugged.error().code, Errc::Disconnected);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
