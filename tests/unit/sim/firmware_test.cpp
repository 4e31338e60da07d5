#include <numeric>

#include <gtest/gtest.h>

#include "core/framing/crc16.h"
#include "core/thunderbots/sim/microcontroller.h"
#include "tests/unit/sim/sim_host.h"

namespace kickstand::thunderbots::sim::test {
namespace {

using Page = std::array<std::uint8_t, wire::kFlashPageBytes>;

class Firmware : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(host.start(0x0001)); }

    /// How long the answer takes, to the millisecond of the reading host; none where there is no answer.
    template <class Request>
    std::optional<Duration> timeOf(const Request& request, Duration limit) {
        const TimePoint begun = host.scheduler.now();
        const std::size_t before = host.count(wire::Pipe::FirmwareResponse);
        host.firmware(0, request);
        while (host.count(wire::Pipe::FirmwareResponse) == before) {
            if (host.scheduler.now() - begun > limit) return std::nullopt;
            host.keepAlive();
            host.scheduler.advance(100us);
            host.drain();
        }
        return host.scheduler.now() - begun;
    }
    void fill(const Page& page) {
        for (std::size_t offset = 0; offset < page.size(); offset += 32) {
            wire::FillPageRequest request{.offset = static_cast<std::uint8_t>(offset), .data = {}};
            request.data.append(ByteView(page).subspan(offset, 32));
            host.firmware(0, request);
            host.run(2ms);
        }
    }
    std::optional<Duration> program(std::uint16_t number, const Page& page) {
        fill(page);
        return timeOf(wire::ProgramPageRequest{.page = number, .crc = crc16(page)}, 100ms);
    }
    std::vector<std::uint8_t> flash(std::uint32_t address, std::size_t length) {
        std::vector<std::uint8_t> bytes(length);
        EXPECT_TRUE(host.sim.readFlash(0, address, bytes));
        return bytes;
    }
    bool awaitReturn(Duration limit) {
        return host.runUntil([&] { return !host.sim.deviceReport().status.alive(0); }, limit) &&
               host.runUntil([&] { return host.sim.deviceReport().status.alive(0); }, limit);
    }
    wire::OperationalParameters readParameters() {
        return std::get<wire::ReadParametersResponse>(host.ask(0, wire::ReadParametersRequest{}).value())
            .parameters;
    }
    static Page numbers() {
        Page page;
        std::iota(page.begin(), page.end(), std::uint8_t{0});
        return page;
    }

    SimHost host{quietOptions()};
};

TEST_F(Firmware, EraseTakesEightSecondsAndMarksTheFlashAsEmptyForGood) {
    wire::OperationalParameters edited = readParameters();
    edited.dribblerDuty = 77;
    ASSERT_TRUE(host.ask(0, wire::SetParametersRequest{edited}));
    const auto time = timeOf(wire::EraseChipRequest{}, 10s);
    ASSERT_TRUE(time);
    EXPECT_GE(*time, 8s);
    EXPECT_LE(*time, 8s + 5ms);
    EXPECT_EQ(flash(0, 4096), std::vector<std::uint8_t>(4096, 0xFF));
    const RobotReport report = host.sim.robot(0);
    EXPECT_EQ(report.committed.flash(), wire::FlashContents::NoData);
    EXPECT_NE(report.shadow.dribblerDuty, 77) << "uncommitted edits are lost";
}

TEST_F(Firmware, ProgramsAPageAfterCheckingItsCrc) {
    ASSERT_TRUE(host.ask(0, wire::EraseChipRequest{}, 10s));
    const auto time = program(8191, numbers());
    ASSERT_TRUE(time);
    EXPECT_GE(*time, 1500us);
    EXPECT_LE(*time, 2ms);
    const Page page = numbers();
    EXPECT_EQ(flash(0x1FFF00, 256), std::vector<std::uint8_t>(page.begin(), page.end()));
}

TEST_F(Firmware, AWrongCrcIsMetWithSilenceAndTheBufferStays) {
    ASSERT_TRUE(host.ask(0, wire::EraseChipRequest{}, 10s));
    const Page page = numbers();
    fill(page);
    const auto wrong = static_cast<std::uint16_t>(crc16(page) ^ 1);
    EXPECT_FALSE(timeOf(wire::ProgramPageRequest{.page = 0, .crc = wrong}, 1s));
    EXPECT_EQ(host.sim.robot(0).wrongCrcs, 1U);
    EXPECT_TRUE(timeOf(wire::ProgramPageRequest{.page = 0, .crc = crc16(page)}, 1s));
    EXPECT_TRUE(timeOf(wire::ProgramPageRequest{.page = 1, .crc = crc16(page)}, 1s)) << "still there";
}

TEST_F(Firmware, ProgrammingOnlyClearsBits) {
    ASSERT_TRUE(host.ask(0, wire::EraseChipRequest{}, 10s));
    Page page;
    page.fill(0xF0);
    ASSERT_TRUE(program(5, page));
    page.fill(0x3C);
    ASSERT_TRUE(program(5, page));
    EXPECT_EQ(flash(5 * 256, 256), std::vector<std::uint8_t>(256, 0x30));
}

TEST_F(Firmware, ABlockCrcTakesAMicrosecondAByte) {
    const auto time = timeOf(wire::BlockCrcRequest{.address = 100, .length = 65536}, 1s);
    ASSERT_TRUE(time);
    EXPECT_GE(*time, 65536us);
    EXPECT_LE(*time, 66ms);
    const auto response = host.ask(0, wire::BlockCrcRequest{.address = 100, .length = 65536});
    ASSERT_TRUE(response);
    EXPECT_EQ(std::get<wire::BlockCrcResponse>(*response),
              (wire::BlockCrcResponse{.address = 100, .length = 65536, .crc = crc16(flash(100, 65536))}));
}

TEST_F(Firmware, WhatLiesOutsideTheFlashIsPassedOverInSilence) {
    EXPECT_FALSE(host.ask(0, wire::BlockCrcRequest{.address = 0x1FFFFF, .length = 2}));
    EXPECT_FALSE(host.ask(0, wire::ProgramPageRequest{.page = 8192, .crc = 0}));
    EXPECT_EQ(host.sim.robot(0).malformed, 2U);
    EXPECT_TRUE(host.ask(0, wire::BlockCrcRequest{.address = 0x1FFFFF, .length = 1}));
}

TEST_F(Firmware, OneRequestAtATime) {
    host.firmware(0, wire::EraseChipRequest{});
    host.run(1s);
    EXPECT_FALSE(host.ask(0, wire::ReadParametersRequest{}));
    EXPECT_EQ(host.sim.robot(0).malformed, 1U);
    host.run(7s);
    EXPECT_EQ(host.count(wire::Pipe::FirmwareResponse), 1U);
    EXPECT_TRUE(host.ask(0, wire::ReadParametersRequest{}));
}

TEST_F(Firmware, TheShadowIsLostAtARebootUnlessCommitted) {
    const wire::OperationalParameters original = readParameters();
    EXPECT_EQ(wire::encodeParameters(original).size(), 6U);
    wire::OperationalParameters edited = original;
    edited.dribblerDuty = 99;
    ASSERT_TRUE(host.ask(0, wire::SetParametersRequest{edited}));
    EXPECT_EQ(readParameters(), edited);
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    ASSERT_TRUE(awaitReturn(10s));
    EXPECT_EQ(readParameters(), original);
    ASSERT_TRUE(host.ask(0, wire::SetParametersRequest{edited}));
    ASSERT_TRUE(host.ask(0, wire::CommitParametersRequest{}));
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    ASSERT_TRUE(awaitReturn(10s));
    EXPECT_EQ(readParameters(), edited);
}

TEST_F(Firmware, ABlockOfAnotherLengthIsNotTaken) {
    wire::OperationalParameters edited = readParameters();
    edited.tail.clear();
    EXPECT_FALSE(host.ask(0, wire::SetParametersRequest{edited}));
    EXPECT_EQ(wire::encodeParameters(readParameters()).size(), 6U);
}

TEST_F(Firmware, ARobotWithAnotherNumberAnswersToItAfterItsReboot) {
    wire::OperationalParameters edited = readParameters();
    edited.robotNumber = 12;
    ASSERT_TRUE(host.ask(0, wire::SetParametersRequest{edited}));
    ASSERT_TRUE(host.ask(0, wire::CommitParametersRequest{}));
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    EXPECT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.aliveRobots == 1U << 12; }, 10s));
}

TEST_F(Firmware, ARebootFollowsItsResponseAndTakesThreeSeconds) {
    host.drive(0, running(50));
    host.run(500ms);
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    const TimePoint begun = host.scheduler.now();
    EXPECT_EQ(host.sim.robot(0).power, RobotPower::Booting);
    ASSERT_TRUE(host.runUntil([&] { return host.sim.robot(0).power == RobotPower::Up; }, 5s));
    EXPECT_GE(host.scheduler.now() - begun, 2990ms);
    EXPECT_LE(host.scheduler.now() - begun, 3s);
    EXPECT_FALSE(host.sim.robot(0).driveFresh);
}

TEST_F(Firmware, ThePageBufferDoesNotSurviveAReboot) {
    ASSERT_TRUE(host.ask(0, wire::EraseChipRequest{}, 10s));
    const Page page = numbers();
    fill(page);
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    ASSERT_TRUE(awaitReturn(10s));
    EXPECT_FALSE(host.ask(0, wire::ProgramPageRequest{.page = 0, .crc = crc16(page)}));
}

TEST_F(Firmware, TheFlashSignatureIsThatOfAllTwoMebibytesAndTakesItsTime) {
    const auto time = timeOf(wire::ReadSignaturesRequest{}, 5s);
    ASSERT_TRUE(time);
    EXPECT_GE(*time, 2097152us);
    const auto response = host.ask(0, wire::ReadSignaturesRequest{}, 5s);
    EXPECT_EQ(std::get<wire::ReadSignaturesResponse>(response.value()).flashCrc,
              crc16(flash(0, wire::kFlashBytes)));
}

TEST_F(Firmware, AMicrocontrollerImageIsCopiedBetweenTwoBoots) {
    const auto before =
        std::get<wire::ReadSignaturesResponse>(host.ask(0, wire::ReadSignaturesRequest{}, 5s).value());
    ASSERT_TRUE(host.ask(0, wire::EraseChipRequest{}, 10s));
    ASSERT_TRUE(program(0, numbers()));
    wire::OperationalParameters parameters = readParameters();
    parameters.flashContents = 1;
    ASSERT_TRUE(host.ask(0, wire::SetParametersRequest{parameters}));
    ASSERT_TRUE(host.ask(0, wire::CommitParametersRequest{}));
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    const TimePoint begun = host.scheduler.now();
    std::vector<RobotPower> states{RobotPower::Booting};
    ASSERT_TRUE(host.runUntil(
        [&] {
            const RobotPower power = host.sim.robot(0).power;
            if (power != states.back()) states.push_back(power);
            return power == RobotPower::Up;
        },
        20s));
    EXPECT_EQ(states, (std::vector{RobotPower::Booting, RobotPower::CopyingImage, RobotPower::Booting,
                                   RobotPower::Up}));
    EXPECT_NEAR(seconds(host.scheduler.now() - begun), 11, 0.02);
    ASSERT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.alive(0); }, 20s));
    EXPECT_EQ(readParameters().flash(), wire::FlashContents::NoData);
    const auto after =
        std::get<wire::ReadSignaturesResponse>(host.ask(0, wire::ReadSignaturesRequest{}, 5s).value());
    EXPECT_NE(after.microcontrollerCrc, before.microcontrollerCrc);
    EXPECT_EQ(after.microcontrollerCrc, crc16(flash(0, Microcontroller::kSignedBytes)));
}

TEST_F(Firmware, WithoutABitstreamItMeasuresNothingAndMovesNothing) {
    ASSERT_TRUE(host.ask(0, wire::EraseChipRequest{}, 10s));
    EXPECT_TRUE(host.sim.robot(0).fpgaConfigured) << "the FPGA keeps what it was given until the reboot";
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    ASSERT_TRUE(awaitReturn(10s));
    host.feedback.clear();
    host.drive(0, running(100));
    host.kick(0, {.t1 = 75});
    host.run(500ms);
    EXPECT_NEAR(host.sim.robot(0).wheelSpeeds[0], 0, 0.1);
    EXPECT_EQ(host.sim.robot(0).kicks, 0U);
    for (const wire::FeedbackBlock& block : host.feedback[0])
        EXPECT_FALSE(block.valid);
    ASSERT_TRUE(program(0, numbers()));
    wire::OperationalParameters parameters = readParameters();
    parameters.flashContents = 0;
    ASSERT_TRUE(host.ask(0, wire::SetParametersRequest{parameters}));
    ASSERT_TRUE(host.ask(0, wire::CommitParametersRequest{}));
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    ASSERT_TRUE(awaitReturn(10s));
    EXPECT_TRUE(host.sim.robot(0).fpgaConfigured);
}

TEST_F(Firmware, LossDelaysTheResponseAndNothingIsDoneTwice) {
    host.perform("loss", -1, 0.4);
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(host.ask(0, wire::ReadParametersRequest{}, 5s)) << i;
        EXPECT_EQ(host.count(wire::Pipe::FirmwareResponse), static_cast<std::size_t>(i + 1));
    }
    EXPECT_EQ(host.sim.robot(0).malformed, 0U);
}

TEST_F(Firmware, AnExperimentSendsItsWholeBuffer) {
    host.perform("experiment", 0, 1);
    host.run(200ms);
    ASSERT_EQ(host.messages.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(host.messages[i].payload.size(), 33U);
        EXPECT_EQ(host.messages[i].payload[0], 32 * i);
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::sim::test
