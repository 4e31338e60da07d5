#include <gtest/gtest.h>

#include "tests/unit/sim/sim_host.h"

namespace kickstand::thunderbots::sim::test {
namespace {

class Cable : public testing::Test {
  protected:
    static ThunderbotsSimOptions options() {
        ThunderbotsSimOptions options = quietOptions();
        options.cableRobot = std::uint8_t{3};
        return options;
    }
    void SetUp() override { host.configure(); }

    SimHost host{options()};
};

TEST_F(Cable, IsARobotWithAnotherProductNumberAndTheSameEndpoints) {
    EXPECT_EQ(loadLe16(host.device.descriptors().device, 10), 0x783A);
    SimHost dongle(quietOptions());
    EXPECT_EQ(host.device.descriptors().configuration, dongle.device.descriptors().configuration);
    EXPECT_TRUE(host.sim.hasRobot(3));
    EXPECT_FALSE(host.sim.hasRobot(0));
}

TEST_F(Cable, ReportsRunRunningAndItsBit) {
    host.run(50ms);
    ASSERT_FALSE(host.statuses.empty());
    EXPECT_EQ(host.statuses.back(),
              (wire::DongleStatus{
                  .eStop = wire::EStop::Run, .radios = wire::RadioState::Running, .aliveRobots = 0x0008}));
}

TEST_F(Cable, HasNoRadiosAndNoChannels) {
    using wire::VendorRequest;
    EXPECT_EQ(host.vendor(wire::kVendorIn, VendorRequest::ReadRadioVersions), UsbHandshake::Stall);
    EXPECT_EQ(host.vendor(wire::kVendorIn, VendorRequest::ReadChannels), UsbHandshake::Stall);
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::SetChannels, 0x0F0E), UsbHandshake::Stall);
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::EnableRadios), UsbHandshake::Stall);
    EXPECT_EQ(host.vendor(wire::kVendorOut, VendorRequest::ResendStatus), UsbHandshake::Ack);
    EXPECT_FALSE(host.perform("e-stop", -1, 2));
    EXPECT_FALSE(host.perform("loss", -1, 0.5));
}

TEST_F(Cable, ItsNumberStandsInTheFeedback) {
    host.run(50ms);
    ASSERT_EQ(host.feedback.size(), 1U);
    EXPECT_TRUE(host.feedback.contains(3));
}

TEST_F(Cable, AnyPacketKeepsTheSetPointsAndASecondOfSilenceBrakes) {
    host.drive(3, running(50));
    host.run(5s);
    EXPECT_NEAR(host.sim.robot(3).wheelSpeeds[0], 50, 0.1);
    host.keepAlive();
    host.stayQuiet(995ms);
    EXPECT_TRUE(host.sim.robot(3).driveFresh);
    host.stayQuiet(5ms);
    EXPECT_FALSE(host.sim.robot(3).driveFresh);
    host.run(1s);
    EXPECT_NEAR(host.sim.robot(3).wheelSpeeds[0], 0, 0.1) << "a keep-alive does not bring set points back";
}

TEST_F(Cable, BlocksForOthersArePassedOverAndMessagesForOthersFail) {
    host.drive(4, running(50));
    host.kick(4, {.t1 = 5});
    host.kick(3, {.t1 = 5});
    host.run(100ms);
    EXPECT_FALSE(host.sim.robot(3).lastDrive.run);
    EXPECT_EQ(host.sim.robot(3).kicks, 1U);
    EXPECT_EQ(host.errors, std::vector<std::uint8_t>{41 + 4});
}

TEST_F(Cable, MessagesComeInEachOnceAndInOrder) {
    for (int i = 0; i < 3; ++i)
        host.perform("experiment", 3, 1);
    host.run(500ms);
    ASSERT_EQ(host.messages.size(), 24U);
    for (std::size_t i = 0; i < host.messages.size(); ++i)
        EXPECT_EQ(host.messages[i].payload[0], 32 * (i % 8));
}

TEST_F(Cable, ARebootUnplugsItAfterTheResponseWasReadAndPlugsItInAgain) {
    ASSERT_TRUE(host.ask(3, wire::RebootRequest{}));
    host.scheduler.advance(10ms);
    EXPECT_FALSE(host.device.attached());
    host.scheduler.advance(3s);
    EXPECT_TRUE(host.device.attached());
    EXPECT_EQ(host.attachments, (std::vector<bool>{false, true}));
    host.configure();
    EXPECT_TRUE(host.ask(3, wire::ReadParametersRequest{}));
}

TEST_F(Cable, ARobotThatLocksOutIsGone) {
    host.perform("battery", 3, 12.5);
    host.run(1500ms);
    EXPECT_FALSE(host.device.attached());
    host.perform("battery", 3, 16);
    host.perform("dead", 3, 0);
    host.scheduler.advance(4s);
    EXPECT_TRUE(host.device.attached());
}

TEST_F(Cable, PulledOutTheRobotBrakesByItself) {
    host.drive(3, running(50));
    host.run(500ms);
    host.perform("plugged", -1, 0);
    EXPECT_FALSE(host.device.attached());
    host.scheduler.advance(1100ms);
    EXPECT_NEAR(host.sim.robot(3).wheelSpeeds[0], 0, 0.5);
    host.perform("plugged", -1, 1);
    EXPECT_TRUE(host.device.attached());
}

TEST_F(Cable, AHaltedMessageEndpointLosesNothing) {
    host.perform("stall", -1, 0x86);
    host.perform("experiment", 3, 1);
    host.run(100ms);
    EXPECT_TRUE(host.messages.empty());
    std::vector<std::uint8_t> in;
    host.device.control({.requestType = 2, .request = 1, .value = 0, .index = 0x86}, {}, in);
    host.run(100ms);
    EXPECT_EQ(host.messages.size(), 8U);
}

}  // namespace
}  // namespace kickstand::thunderbots::sim::test
