#include <random>

#include <gtest/gtest.h>

#include "tests/unit/sim/sim_host.h"

namespace kickstand::thunderbots::sim::test {
namespace {

std::vector<std::uint8_t> randomBytes(std::mt19937& random, std::size_t most) {
    std::vector<std::uint8_t> bytes(random() % (most + 1));
    for (std::uint8_t& byte : bytes)
        byte = static_cast<std::uint8_t>(random());
    return bytes;
}

class Hostile : public testing::TestWithParam<bool> {
  protected:
    static ThunderbotsSimOptions options() {
        ThunderbotsSimOptions options = quietOptions(0xFFFF);
        if (GetParam()) options.cableRobot = std::uint8_t{2};
        return options;
    }

    SimHost host{options()};
    std::mt19937 random{5};
};

TEST_P(Hostile, RandomPacketsAreCountedAndLeaveTheDeviceWorking) {
    host.configure();
    host.run(1s);
    std::size_t sent = 0;
    for (int i = 0; i < 20000; ++i) {
        auto packet = randomBytes(random, 64);
        // Half of them begin like something that means something.
        if (packet.size() > 1 && i % 4 == 0) packet[0] = 12;
        if (packet.size() > 1 && i % 2 == 0) packet[1] = static_cast<std::uint8_t>(packet[1] & 0xF0);
        sent += host.out(i % 3 == 0 ? wire::Endpoint::MessageOut : wire::Endpoint::StateOut, packet) ==
                UsbHandshake::Ack;
        if (i % 16 == 0) host.run(1ms);
    }
    EXPECT_GT(sent, 10000U);
    EXPECT_GT(host.sim.deviceReport().malformed, 1000U);
    EXPECT_FALSE(host.errors.empty());
    host.run(60s);
    const std::uint64_t before = host.sim.robot(2).kicks;
    ASSERT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.alive(2); }, 60s));
    EXPECT_EQ(host.kick(2, {.t1 = 5}), UsbHandshake::Ack);
    host.run(1s);
    EXPECT_EQ(host.sim.robot(2).kicks, before + 1);
}

TEST_P(Hostile, RandomControlTransfersNeverBreakIt) {
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::uint8_t> in;
        const UsbSetup setup{
            .requestType = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() & 0xC3),
            .request = static_cast<std::uint8_t>(random() % 16),
            .value = static_cast<std::uint16_t>(random() % 2 == 0 ? random() % 4 : random()),
            .index = static_cast<std::uint16_t>(random() % 256),
            .length = static_cast<std::uint16_t>(random())};
        EXPECT_NE(host.device.control(setup, randomBytes(random, 8), in), UsbHandshake::Nak);
        if (i % 64 == 0) host.stayQuiet(5ms);
    }
    host.configure();
    EXPECT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.alive(2); }, 5s));
}

TEST_P(Hostile, EndpointsThatDoNotExistStall) {
    host.configure();
    std::array<std::uint8_t, 64> buffer{};
    for (int endpoint = 0; endpoint < 256; ++endpoint) {
        const auto address = static_cast<std::uint8_t>(endpoint);
        std::size_t actual = 0;
        if (endpoint != 0x05 && endpoint != 0x06) {
            EXPECT_EQ(host.device.out(address, buffer), UsbHandshake::Stall) << endpoint;
        }
        if (endpoint < 0x81 || endpoint > 0x86) {
            EXPECT_EQ(host.device.in(address, buffer, actual), UsbHandshake::Stall) << endpoint;
        }
    }
    std::size_t actual = 0;
    EXPECT_EQ(host.device.in(0x83, buffer, actual), UsbHandshake::Nak) << "statistics are never sent";
}

TEST_P(Hostile, ABufferTooSmallIsNeverOverrun) {
    host.configure();
    host.scheduler.advance(1s);
    for (const int endpoint : {0x81, 0x82, 0x84, 0x85, 0x86}) {
        std::array<std::uint8_t, 3> buffer{};
        std::size_t actual = 0;
        host.device.in(static_cast<std::uint8_t>(endpoint), buffer, actual);
        EXPECT_LE(actual, buffer.size());
    }
}

TEST_P(Hostile, UnpluggingAtAnyMomentIsSurvived) {
    for (int i = 0; i < 200; ++i) {
        host.configure();
        host.scheduler.advance(std::chrono::milliseconds(random() % 400));
        host.drive(2, running(50));
        host.kick(2, {.t1 = 5});
        host.firmware(2, wire::ReadParametersRequest{});
        host.scheduler.advance(std::chrono::microseconds(random() % 3000));
        host.perform("plugged", -1, 0);
        host.scheduler.advance(std::chrono::milliseconds(random() % 50));
        host.perform("plugged", -1, 1);
    }
    host.configure();
    EXPECT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.alive(2); }, 5s));
    EXPECT_LT(host.scheduler.pending(), 20U);
}

INSTANTIATE_TEST_SUITE_P(Device, Hostile, testing::Bool(),
                         [](const auto& cable) { return cable.param ? "Cable" : "Dongle"; });

}  // namespace
}  // namespace kickstand::thunderbots::sim::test
