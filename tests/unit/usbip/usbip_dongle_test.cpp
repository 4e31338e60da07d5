#include <cmath>

#include <gtest/gtest.h>

#include "core/thunderbots/sim/thunderbots_sim.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/micropacket.h"
#include "tests/unit/usbip/usbip_rig.h"

// The simulated dongle, exported: from the first descriptor that a kernel reads to robots that drive and
// stop.

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;
using namespace thunderbots;
using Bytes = std::vector<std::uint8_t>;
using Status = usbip::TransferStatus;
using wire::Endpoint;
using wire::VendorRequest;

constexpr int kRobot = 3;

/// Devices need the clock of the rig that serves them, so they are made for it.
class ExportedDongle : public ::testing::Test {
  protected:
    ExportedDongle() : sim_(clock_, options()) {}

    static sim::ThunderbotsSimOptions options() {
        sim::ThunderbotsSimOptions made;
        made.robots = 1U << kRobot;
        made.pace = sim::RadioPace::Ideal;
        return made;
    }

    RawClient& connect() {
        auto [server, client] = makeMemoryStreams(clock_);
        connection_ = std::make_unique<UsbipConnection>(clock_, std::move(server), hall_, UsbipLimits{},
                                                        [this] { connection_.reset(); });
        RawClient& made = clients_.emplace_back(clock_, std::move(client));
        made.read();
        made.import("1-1");
        clock_.runPending();
        return made;
    }
    RawClient::Answer await(RawClient& client, std::uint32_t sequence) {
        EXPECT_TRUE(clock_.runUntil([&] { return client.answer(sequence) != nullptr; }, 60s));
        return client.answer(sequence) ? *client.answer(sequence) : RawClient::Answer{};
    }
    Status vendor(RawClient& client, VendorRequest request, std::uint16_t value = 0) {
        const UsbSetup setup{wire::kVendorOut, static_cast<std::uint8_t>(request), value, 0, 0};
        return await(client, client.controlOut(setup)).reply.status;
    }
    /// Everything of a start (protocol 3.4): configuration, radios, status until they run, the robot found.
    void startUp(RawClient& client) {
        ASSERT_EQ(await(client, client.controlOut({0x00, 9, 0, 0, 0})).reply.status, Status::Ok);
        ASSERT_EQ(await(client, client.controlOut({0x00, 9, 1, 0, 0})).reply.status, Status::Ok);
        ASSERT_EQ(vendor(client, VendorRequest::SetChannels, 0x0F0E), Status::Ok);
        ASSERT_EQ(vendor(client, VendorRequest::EnableRadios), Status::Ok);
        ASSERT_EQ(vendor(client, VendorRequest::ResendStatus), Status::Ok);
        ASSERT_TRUE(awaitStatus(client, [](const wire::DongleStatus& status) {
            return status.radios == wire::RadioState::Running && status.alive(kRobot);
        }));
    }
    bool awaitStatus(RawClient& client, const std::function<bool(const wire::DongleStatus&)>& holds) {
        for (int i = 0; i < 50; ++i) {
            const std::uint32_t sequence = client.in(wire::address(Endpoint::Status), wire::kStatusBytes);
            const auto status = wire::decodeStatus(await(client, sequence).data);
            if (status && holds(*status)) return true;
        }
        return false;
    }
    std::uint32_t drive(RawClient& client, std::int16_t speed) {
        wire::DriveBlock block;
        block.run = true;
        block.wheels = {speed, speed, speed, speed};
        wire::StatePacketBuilder builder;
        EXPECT_TRUE(builder.addDrive(kRobot, *wire::encodeDrive(block)));
        const ByteView packet = builder.packet();
        return client.out(wire::address(Endpoint::StateOut), {packet.begin(), packet.end()});
    }
    bool robotStands() { return std::abs(sim_.robot(kRobot).wheelSpeeds[0]) < 1; }

    FakeScheduler clock_;
    sim::ThunderbotsSim sim_;
    UsbipHall hall_{.exports = UsbipExports::make(std::vector<UsbipExport>{{"1-1", &sim_.device()}}).value()};
    std::unique_ptr<UsbipConnection> connection_;
    std::list<RawClient> clients_;
};

TEST_F(ExportedDongle, AKernelFindsWhatItEnumerates) {
    RawClient& client = connect();
    const auto device = await(client, client.controlIn({0x80, 6, 0x0100, 0, 64}, 64)).data;
    ASSERT_EQ(device.size(), 18U);
    EXPECT_EQ(loadLe16(device, 8), wire::kVendorId);
    EXPECT_EQ(loadLe16(device, 10), wire::kDongleProductId);
    const auto head = await(client, client.controlIn({0x80, 6, 0x0200, 0, 9}, 9)).data;
    ASSERT_EQ(head.size(), 9U);
    const std::uint16_t total = loadLe16(head, 2);
    const auto whole = await(client, client.controlIn({0x80, 6, 0x0200, 0, total}, total)).data;
    EXPECT_EQ(whole, sim_.device().descriptors().configuration);
    const auto name = await(client, client.controlIn({0x80, 6, 0x0302, 0x0409, 255}, 255)).data;
    ASSERT_GE(name.size(), 4U);
    EXPECT_EQ(name[0], name.size());
    EXPECT_EQ(name[2], 'T');
    EXPECT_EQ(await(client, client.controlIn({0x80, 6, 0x0600, 0, 10}, 10)).reply.status, Status::Stall)
        << "no high-speed device";
}

TEST_F(ExportedDongle, RobotsDriveAndFeedBack) {
    RawClient& client = connect();
    startUp(client);
    EXPECT_EQ(vendor(client, VendorRequest::SetChannels, 0x0F0E), Status::Stall) << "too late";
    EXPECT_EQ(await(client, drive(client, 40)).reply.status, Status::Ok);
    clock_.advance(500ms);
    EXPECT_EQ(sim_.robot(kRobot).lastDrive.wheels[0], 40);
    EXPECT_FALSE(robotStands());
    const auto feedback = await(client, client.in(wire::address(Endpoint::StateIn), wire::kPacketBytes));
    EXPECT_EQ(feedback.data.size(), wire::kFeedbackMicropacketBytes);
}

TEST_F(ExportedDongle, AClientThatGoesTakesTheRadiosWithIt) {
    RawClient& client = connect();
    startUp(client);
    await(client, drive(client, 40));
    clock_.advance(500ms);
    client.close();
    clock_.advance(1ms);
    EXPECT_EQ(sim_.deviceReport().status.radios, wire::RadioState::PreInit);
    clock_.advance(1100ms);
    EXPECT_FALSE(sim_.robot(kRobot).driveFresh);
    clock_.advance(2s);
    EXPECT_TRUE(robotStands());
    startUp(connect());
    clock_.advance(2s);
    EXPECT_TRUE(robotStands()) << "what an earlier client asked for came back";
}

TEST_F(ExportedDongle, PulledOutInMidDriveItComesBackWithNothingLeft) {
    RawClient& client = connect();
    startUp(client);
    await(client, drive(client, 40));
    const std::uint32_t waiting = client.in(wire::address(Endpoint::MessageIn), wire::kPacketBytes);
    clock_.advance(1ms);
    ASSERT_TRUE(sim_.control().perform("plugged", -1, 0));
    clock_.advance(0ms);
    ASSERT_NE(client.answer(waiting), nullptr);
    EXPECT_EQ(client.answer(waiting)->reply.status, Status::Shutdown);
    EXPECT_EQ(connect().status(), usbip::OpStatus::NoDevice);
    clock_.advance(3s);
    EXPECT_TRUE(client.closed());
    EXPECT_TRUE(robotStands());
    ASSERT_TRUE(sim_.control().perform("plugged", -1, 1));
    RawClient& again = connect();
    startUp(again);
    clock_.advance(1s);
    EXPECT_TRUE(robotStands());
    EXPECT_EQ(await(again, drive(again, 7)).reply.status, Status::Ok);
}

TEST_F(ExportedDongle, AStalledEndpointIsClearedByTheHost) {
    RawClient& client = connect();
    startUp(client);
    const std::uint8_t endpoint = wire::address(Endpoint::StateOut);
    ASSERT_TRUE(sim_.control().perform("stall", -1, endpoint));
    EXPECT_EQ(await(client, drive(client, 1)).reply.status, Status::Stall);
    EXPECT_EQ(await(client, client.controlOut({0x02, 1, 0, endpoint, 0})).reply.status, Status::Ok);
    EXPECT_EQ(await(client, drive(client, 1)).reply.status, Status::Ok);
}

}  // namespace
}  // namespace kickstand::testing
