#include <gtest/gtest.h>

#include "core/framing/crc16.h"
#include "core/link/loopback/loopback_usb_link.h"
#include "tests/unit/sim/sim_host.h"

namespace kickstand::thunderbots::sim::test {
namespace {

using wire::Endpoint;
using wire::VendorRequest;

std::vector<std::uint8_t> readControl(UsbDeviceModel& device, VendorRequest request) {
    std::vector<std::uint8_t> in;
    const UsbSetup setup{
        .requestType = wire::kVendorIn, .request = static_cast<std::uint8_t>(request), .length = 64};
    EXPECT_EQ(device.control(setup, {}, in), UsbHandshake::Ack);
    return in;
}

TEST(Dongle, IsDescribedAsTheProtocolSays) {
    SimHost host(quietOptions());
    const UsbDescriptors& all = host.device.descriptors();
    EXPECT_EQ(loadLe16(all.device, 8), 0x04D8);
    EXPECT_EQ(loadLe16(all.device, 10), 0x7839);
    EXPECT_EQ(loadLe16(all.device, 12), 0x0100);
    EXPECT_EQ(all.device[7], 8);
    EXPECT_EQ(all.device[16], 0) << "there is no serial number";
    ASSERT_EQ(all.strings.size(), 4U);
    EXPECT_EQ(all.strings.at(all.device[15]), "Thunderbots XBee Dongle");
    struct Expected {
        int address, size, interval_ms, interface;
        UsbEndpointInfo::Type type;
    };
    constexpr auto kInterrupt = UsbEndpointInfo::Type::Interrupt;
    const std::vector<Expected> expected{{0x81, 4, 25, 0, kInterrupt},
                                         {0x82, 64, 25, 0, kInterrupt},
                                         {0x83, 8, 0, 0, UsbEndpointInfo::Type::Bulk},
                                         {0x84, 64, 25, 0, kInterrupt},
                                         {0x05, 64, 1, 1, kInterrupt},
                                         {0x85, 64, 1, 1, kInterrupt},
                                         {0x06, 64, 1, 1, kInterrupt},
                                         {0x86, 64, 1, 1, kInterrupt}};
    ASSERT_EQ(all.endpoints.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(all.endpoints[i].address, expected[i].address);
        EXPECT_EQ(all.endpoints[i].packetSize, expected[i].size);
        EXPECT_EQ(all.endpoints[i].interval_ms, expected[i].interval_ms);
        EXPECT_EQ(all.endpoints[i].interface, expected[i].interface);
        EXPECT_EQ(all.endpoints[i].type, expected[i].type);
    }
}

TEST(Dongle, OpensOverALoopback) {
    FakeScheduler scheduler;
    ThunderbotsSim sim(scheduler);
    LoopbackUsbLink link(scheduler, sim.device());
    std::optional<Result<UsbDeviceInfo>> opened;
    link.open([&](Result<UsbDeviceInfo> result) { opened = std::move(result); });
    scheduler.advance(1s);
    ASSERT_TRUE(opened && *opened);
    EXPECT_EQ((*opened)->productName, "Thunderbots XBee Dongle");
    EXPECT_EQ((*opened)->manufacturer, "UBC Thunderbots Robocup Small Size Team");
}

TEST(Dongle, TakesNothingUntilItIsConfigured) {
    SimHost host(quietOptions());
    EXPECT_EQ(host.keepAlive(), UsbHandshake::Stall);
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::EnableRadios), UsbHandshake::Stall);
    std::array<std::uint8_t, 64> buffer{};
    std::size_t actual = 0;
    EXPECT_EQ(host.device.in(0x85, buffer, actual), UsbHandshake::Stall);
}

TEST(Dongle, RadiosStartOneAfterTheOtherAndTheStatusTellsEachChange) {
    SimHost host(quietOptions(0x0009));
    ASSERT_TRUE(host.start(0x0009));
    host.run(100ms);
    std::vector<wire::RadioState> states;
    for (const wire::DongleStatus& status : host.statuses) {
        EXPECT_EQ(status.eStop, wire::EStop::Run);
        if (states.empty() || states.back() != status.radios) states.push_back(status.radios);
    }
    EXPECT_EQ(states, (std::vector{wire::RadioState::InitRadio0, wire::RadioState::InitRadio1,
                                   wire::RadioState::Running}));
    EXPECT_EQ(host.statuses.back().aliveRobots, 0x0009);
    const std::size_t before = host.statuses.size();
    host.run(2s);
    EXPECT_EQ(host.statuses.size(), before) << "an unchanged status is not sent";
    host.vendor(wire::kVendorOut, VendorRequest::ResendStatus);
    host.drain();
    EXPECT_EQ(host.statuses.size(), before + 1);
    EXPECT_NE(host.text.find("ready"), std::string::npos);
}

TEST(Dongle, AFailingRadioIsReportedByItsNumber) {
    for (const int radio : {0, 1}) {
        SimHost host(quietOptions());
        host.perform("radio-failure", -1, radio);
        host.configure();
        host.run(1s);
        EXPECT_EQ(static_cast<int>(host.statuses.back().radios), 4 + radio);
        EXPECT_EQ(host.errors, (std::vector<std::uint8_t>{static_cast<std::uint8_t>(22 + radio)}));
        EXPECT_EQ(host.sim.deviceReport().status.aliveRobots, 0);
        host.perform("radio-failure", -1, -1);
        EXPECT_TRUE(host.start(0x0001));
    }
}

TEST(Dongle, ARadioThatFailsWhileItRunsLosesTheRobotsAndTheMessages) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.perform("loss", -1, 1);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(host.kick(0, {.t1 = 1}), UsbHandshake::Ack);
    EXPECT_EQ(host.kick(0, {.t1 = 1}), UsbHandshake::Nak);
    host.perform("radio-failure", -1, 1);
    host.drain();
    EXPECT_EQ(host.statuses.back().radios, wire::RadioState::Radio1Failed);
    EXPECT_EQ(host.statuses.back().aliveRobots, 0);
    EXPECT_EQ(std::ranges::count(host.errors, 41), 6);
    EXPECT_EQ(host.sim.deviceReport().messagesHeld, 0U);
}

TEST(Dongle, ChannelsCanBeSetUntilTheRadiosAreEnabledAndSurviveUnplugging) {
    SimHost host(quietOptions());
    host.setConfiguration(1);
    EXPECT_EQ(readControl(host.device, VendorRequest::ReadChannels), (std::vector<std::uint8_t>{0x0E, 0x0F}));
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::SetChannels, 0x1A0B), UsbHandshake::Ack);
    for (const std::uint16_t wrong :
         std::initializer_list<std::uint16_t>{0x0A0B, 0x1B0B, 0x0B0A, 0x0000, 0xFFFF})
        EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::SetChannels, wrong), UsbHandshake::Stall);
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::EnableRadios), UsbHandshake::Ack);
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::SetChannels, 0x0F0E), UsbHandshake::Stall);
    host.perform("plugged", -1, 0);
    host.perform("plugged", -1, 1);
    host.setConfiguration(1);
    EXPECT_EQ(readControl(host.device, VendorRequest::ReadChannels), (std::vector<std::uint8_t>{0x0B, 0x1A}));
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::SetChannels, 0x0F0E), UsbHandshake::Ack);
}

TEST(Dongle, StoredChannelsThatDoNotExistAreReplaced) {
    ThunderbotsSimOptions options = quietOptions();
    options.dongleChannels = {.channel0 = 0xFF, .channel1 = 0x0C};
    SimHost host(options);
    EXPECT_EQ(host.sim.deviceReport().channels, wire::Channels{});
}

TEST(Dongle, UnknownRequestsStall) {
    SimHost host(quietOptions());
    host.setConfiguration(1);
    std::vector<std::uint8_t> in;
    EXPECT_EQ(readControl(host.device, VendorRequest::ReadRadioVersions).size(), 4U);
    for (const auto& [type, request] : std::vector<std::pair<int, int>>{{wire::kVendorIn, 2},
                                                                        {wire::kVendorOut, 0},
                                                                        {wire::kVendorOut, 5},
                                                                        {0x41, 4},
                                                                        {0x20, 4},
                                                                        {0xC2, 1}}) {
        const UsbSetup setup{.requestType = static_cast<std::uint8_t>(type),
                             .request = static_cast<std::uint8_t>(request)};
        EXPECT_EQ(host.device.control(setup, {}, in), UsbHandshake::Stall) << type << ' ' << request;
    }
}

TEST(Dongle, DeadManZeroesTheFirstByteAfterTwoSecondsUntilANewBlockCame) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    wire::DriveBlock block = running(80);
    block.charge = true;
    block.testClass = 1;
    host.drive(0, block);
    host.stayQuiet(1990ms);
    EXPECT_EQ(host.sim.robot(0).lastDrive, block) << "rebroadcasts keep the robot fresh";
    EXPECT_TRUE(host.sim.robot(0).driveFresh);
    host.stayQuiet(20ms);
    wire::DriveBlock zeroed = block;
    zeroed.run = zeroed.charge = false;
    EXPECT_EQ(host.sim.robot(0).lastDrive, zeroed) << "only the first byte is zeroed";
    host.run(3s);
    EXPECT_EQ(host.sim.robot(0).lastDrive, zeroed) << "a keep-alive does not bring it back";
    host.drive(0, block);
    host.run(20ms);
    EXPECT_EQ(host.sim.robot(0).lastDrive, block);
}

TEST(Dongle, KeepAlivesKeepTheLastSetPoints) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.drive(0, running(60));
    host.run(60s);
    EXPECT_NEAR(host.sim.robot(0).wheelSpeeds[0], 60, 0.1);
}

TEST(Dongle, TheEStopMasksDriveWhileItIsNotInRunAndSetPointsComeBack) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.drive(0, running(60));
    host.run(500ms);
    for (const int position : {2, 1, 0}) {
        host.perform("e-stop", -1, position);
        host.run(300ms);
        EXPECT_FALSE(host.sim.robot(0).lastDrive.run);
        EXPECT_NEAR(host.sim.robot(0).wheelSpeeds[0], 0, 0.1);
        EXPECT_EQ(static_cast<int>(host.statuses.back().eStop), position);
    }
    host.kick(0, {.t1 = 75});
    host.run(50ms);
    EXPECT_EQ(host.sim.robot(0).kicks, 1U) << "kicks pass";
    host.perform("e-stop", -1, 3);
    host.run(500ms);
    EXPECT_NEAR(host.sim.robot(0).wheelSpeeds[0], 60, 0.1);
}

TEST(Dongle, FeedbackIsSentWhenItDiffersAndFiveToAPacket) {
    SimHost host(quietOptions(0xFFFF));
    ASSERT_TRUE(host.start(0xFFFF));
    host.run(500ms);
    host.feedback.clear();
    host.statePackets.clear();
    host.run(1s);
    EXPECT_TRUE(host.feedback.empty()) << "nothing changed";
    host.perform("ball", -1, 1);
    host.run(100ms);
    EXPECT_EQ(host.feedback.size(), 16U);
    for (const auto& [robot, blocks] : host.feedback)
        EXPECT_EQ(blocks.size(), 1U) << static_cast<int>(robot);
    EXPECT_LE(std::ranges::max(host.statePackets), 5U);
    EXPECT_EQ(host.statePackets.size(), 4U);
}

TEST(Dongle, TheNewestFeedbackReplacesOneThatWaits) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.run(100ms);
    host.feedback.clear();
    for (const double volts : {14.0, 15.0, 16.0}) {
        host.perform("battery", 0, volts);
        host.scheduler.advance(50ms);
    }
    host.drain();
    EXPECT_EQ(host.feedback[0].size(), 1U);
}

TEST(Dongle, FeedbackThatWentBackToWhatTheHostKnowsIsNotSent) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.run(100ms);
    host.feedback.clear();
    host.perform("ball", 0, 1);
    host.scheduler.advance(10ms);
    host.perform("ball", 0, 0);
    host.scheduler.advance(10ms);
    host.drain();
    EXPECT_TRUE(host.feedback.empty());
}

TEST(Dongle, HoldsSixMessagesAndRefusesTheSeventhUntilOneIsGone) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.perform("loss", -1, 1);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(host.kick(0, {.t1 = static_cast<std::uint8_t>(i)}), UsbHandshake::Ack);
    EXPECT_EQ(host.kick(0, {.t1 = 6}), UsbHandshake::Nak);
    host.readyEndpoints.clear();
    host.perform("loss", -1, 0);
    host.run(10ms);
    EXPECT_EQ(std::ranges::count(host.readyEndpoints, 0x06), 1);
    EXPECT_EQ(host.kick(0, {.t1 = 6}), UsbHandshake::Ack);
    host.run(10ms);
    const RobotReport report = host.sim.robot(0);
    ASSERT_EQ(report.kicks, 7U);
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_EQ(report.lastKicks[i].pulses[0].width_us, 32 * static_cast<int>(i)) << "in order";
}

TEST(Dongle, AMessageForARobotThatIsNotAliveFails) {
    SimHost host(quietOptions(0x0001));
    ASSERT_TRUE(host.start(0x0001));
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(host.kick(9, {.t1 = 1}), UsbHandshake::Ack);
    host.run(100ms);
    EXPECT_EQ(host.errors, std::vector<std::uint8_t>(20, 41 + 9));
}

TEST(Dongle, BadPacketsAreNamedInTheErrorQueue) {
    SimHost host(quietOptions());
    host.configure();
    const auto state = [&host](std::vector<std::uint8_t> packet) {
        host.errors.clear();
        EXPECT_EQ(host.out(Endpoint::StateOut, packet), UsbHandshake::Ack);
        host.drain();
        return host.errors;
    };
    using Codes = std::vector<std::uint8_t>;
    EXPECT_EQ(state({12, 0x00}), Codes{36}) << "its length points past the packet";
    EXPECT_EQ(state({12, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), Codes{37}) << "no such pipe";
    EXPECT_EQ(state({2, 0x00}), Codes{38});
    EXPECT_EQ(state({0, 0x00}), Codes{38});
    EXPECT_EQ(state({1}), Codes{38});
    EXPECT_EQ(state(std::vector<std::uint8_t>(65, 1)), Codes{36});
    EXPECT_EQ(state({}), Codes{});
    host.errors.clear();
    EXPECT_EQ(host.out(Endpoint::MessageOut, std::vector<std::uint8_t>{0x04, 1}), UsbHandshake::Ack);
    EXPECT_EQ(host.out(Endpoint::MessageOut, {}), UsbHandshake::Ack);
    host.drain();
    EXPECT_EQ(host.errors, (Codes{37, 38}));
    EXPECT_EQ(host.sim.deviceReport().malformed, 8U);
}

TEST(Dongle, WhatStandsBeforeADamagedMicropacketIsTaken) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    std::vector<std::uint8_t> packet{12, 0x00};
    const auto block = wire::encodeDrive(running(30)).value();
    packet.insert(packet.end(), block.begin(), block.end());
    packet.insert(packet.end(), {12, 0x10, 0x80});
    host.out(Endpoint::StateOut, packet);
    host.run(10ms);
    EXPECT_EQ(host.sim.robot(0).lastDrive, running(30));
    EXPECT_EQ(host.errors, (std::vector<std::uint8_t>{36}));
}

TEST(Dongle, AFullErrorQueueEndsWithTheCodeThatSaysSo) {
    SimHost host(quietOptions());
    host.configure();
    for (int i = 0; i < 100; ++i)
        host.perform("error", -1, 105);
    host.drain();
    ASSERT_EQ(host.errors.size(), 64U);
    EXPECT_EQ(host.errors.back(), 40);
    EXPECT_EQ(host.errors.front(), 105);
}

TEST(Dongle, ConfigurationZeroForgetsEverything) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.drive(0, running(60));
    host.run(100ms);
    host.setConfiguration(0);
    EXPECT_EQ(host.sim.deviceReport().status.radios, wire::RadioState::PreInit);
    EXPECT_EQ(host.sim.deviceReport().status.aliveRobots, 0);
    ASSERT_TRUE(host.start(0x0001));
    host.run(100ms);
    EXPECT_EQ(host.sim.robot(0).lastDrive, wire::brakedBlock());
}

TEST(Dongle, UnpluggedItLosesPowerAndTheRobotsTimeOut) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.drive(0, running(60));
    host.run(500ms);
    host.perform("plugged", -1, 0);
    EXPECT_EQ(host.attachments, std::vector<bool>{false});
    host.scheduler.advance(900ms);
    EXPECT_NEAR(host.sim.robot(0).wheelSpeeds[0], 60, 0.1);
    host.scheduler.advance(300ms);
    EXPECT_NEAR(host.sim.robot(0).wheelSpeeds[0], 0, 0.1);
    EXPECT_EQ(host.scheduler.pending(), 0U) << "an unplugged dongle costs nothing";
    host.perform("plugged", -1, 1);
    EXPECT_EQ(host.attachments, (std::vector<bool>{false, true}));
    EXPECT_EQ(host.keepAlive(), UsbHandshake::Stall) << "fresh: not configured";
    ASSERT_TRUE(host.start(0x0001));
    EXPECT_EQ(host.sim.robot(0).boots, 1U) << "the robot lived on";
}

TEST(Dongle, AHaltedEndpointStallsUntilCleared) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.perform("stall", -1, 0x05);
    EXPECT_EQ(host.keepAlive(), UsbHandshake::Stall);
    std::vector<std::uint8_t> in;
    EXPECT_EQ(host.device.control({.requestType = 2, .request = 1, .value = 0, .index = 0x05}, {}, in),
              UsbHandshake::Ack);
    EXPECT_EQ(host.keepAlive(), UsbHandshake::Ack);
    EXPECT_FALSE(host.perform("stall", -1, 0x07));
}

TEST(Dongle, SaysWhenAnEndpointThatRefusedHasSomething) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.run(100ms);
    host.readyEndpoints.clear();
    host.perform("ball", 0, 1);
    host.scheduler.advance(10ms);
    EXPECT_EQ(host.readyEndpoints, std::vector<std::uint8_t>{0x85}) << "once, not for every block";
}

}  // namespace
}  // namespace kickstand::thunderbots::sim::test
