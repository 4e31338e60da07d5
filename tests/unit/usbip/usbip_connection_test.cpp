#include "core/usbip/usbip_connection.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/support/usb/fake_usb_device.h"
#include "tests/unit/usbip/usbip_rig.h"

// What a client that keeps to the protocol gets.

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;
using Device = FakeUsbDevice;
using Kind = usbip::Command::Kind;
using Status = usbip::TransferStatus;
using usbip::OpStatus;

constexpr UsbSetup kConfigure{0x00, 9, 1, 0, 0};
constexpr UsbSetup kDeviceDescriptor{0x80, 6, 0x0100, 0, 18};

Bytes packet(std::size_t size) {
    Bytes bytes(size);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    return bytes;
}

class UsbipConversation : public ::testing::Test {
  protected:
    /// A client that has imported and configured the device.
    RawClient& host() {
        RawClient& client = rig_.connectAndImport("1-1");
        EXPECT_EQ(rig_.await(client, client.controlOut(kConfigure)).reply.status, Status::Ok);
        return client;
    }
    double ms(TimePoint time) const { return seconds(time - TimePoint()) * 1000; }

    Device device_;
    Device other_;
    UsbipRig rig_{{{"1-1", &device_}, {"1-2.3", &other_}}};
};

TEST_F(UsbipConversation, TheListTellsWhatIsThere) {
    RawClient& client = rig_.connect();
    client.list();
    rig_.advance(0ms);
    EXPECT_EQ(client.status(), OpStatus::Ok);
    ASSERT_EQ(client.devices().size(), 2U);
    const usbip::Device& first = client.devices().front();
    EXPECT_EQ(first.busId, "1-1");
    EXPECT_EQ(first.vendor, Device::kVendor);
    EXPECT_EQ(first.product, Device::kProduct);
    EXPECT_EQ(first.release, 0x0123);
    EXPECT_EQ(first.bus, 1U);
    EXPECT_EQ(first.speed, usbip::Speed::FullSpeed);
    EXPECT_EQ(first.configurations, 1);
    EXPECT_EQ(first.interfaces, (std::vector<usbip::InterfaceClass>{{0xFF, 0, 0}, {0xFF, 0, 0}}));
    EXPECT_NE(first.id(), client.devices().back().id());
    EXPECT_TRUE(client.closed()) << "a list is all there is to such a conversation";
    EXPECT_EQ(rig_.connections(), 0U);
}

TEST_F(UsbipConversation, AnUnpluggedDeviceIsNeitherListedNorGiven) {
    device_.unplug();
    RawClient& lister = rig_.connect();
    lister.list();
    RawClient& client = rig_.connect();
    client.import("1-1");
    rig_.advance(0ms);
    ASSERT_EQ(lister.devices().size(), 1U);
    EXPECT_EQ(lister.devices().front().busId, "1-2.3");
    EXPECT_EQ(client.status(), OpStatus::NoDevice);
    EXPECT_TRUE(client.closed());
}

TEST_F(UsbipConversation, AnUnknownBusIdIsNoDevice) {
    RawClient& client = rig_.connect();
    client.import("7-7");
    rig_.advance(0ms);
    EXPECT_EQ(client.status(), OpStatus::NoDevice);
    EXPECT_EQ(rig_.report().imports, 0U);
    EXPECT_EQ(rig_.report().malformed, 0U);
}

TEST_F(UsbipConversation, AnImportTellsTheDevice) {
    RawClient& client = rig_.connectAndImport("1-2.3");
    EXPECT_EQ(client.device().busId, "1-2.3");
    EXPECT_EQ(client.device().vendor, Device::kVendor);
    EXPECT_FALSE(client.closed());
    EXPECT_EQ(rig_.report().imports, 1U);
    EXPECT_TRUE(rig_.inUse());
}

TEST_F(UsbipConversation, ASecondClientFindsTheDeviceBusyUntilTheFirstLeaves) {
    RawClient& first = host();
    RawClient& second = rig_.connect();
    second.import("1-1");
    rig_.advance(0ms);
    EXPECT_EQ(second.status(), OpStatus::Busy);
    EXPECT_TRUE(second.closed());
    rig_.connectAndImport("1-2.3");
    first.close();
    rig_.advance(0ms);
    EXPECT_EQ(device_.configurations(), (Bytes{1, 0})) << "given back as by a bus that loses its host";
    host();
    EXPECT_EQ(rig_.report().imports, 3U);
}

TEST_F(UsbipConversation, DescriptorsCanBeReadBeforeItIsConfigured) {
    RawClient& client = rig_.connectAndImport("1-1");
    const auto whole = rig_.await(client, client.controlIn(kDeviceDescriptor, 18));
    EXPECT_EQ(whole.reply.status, Status::Ok);
    EXPECT_EQ(whole.data, device_.descriptors().device);
    UsbSetup greedy = kDeviceDescriptor;
    greedy.length = 64;
    EXPECT_EQ(rig_.await(client, client.controlIn(greedy, 64)).data.size(), 18U);
    EXPECT_EQ(rig_.await(client, client.controlIn(greedy, 8)).data.size(), 8U) << "room for no more";
}

TEST_F(UsbipConversation, ControlTransfersGoBothWays) {
    RawClient& client = host();
    const auto stored = rig_.await(client, client.controlOut({0x40, Device::kStore, 0, 0, 3}, {1, 2, 3}));
    EXPECT_EQ(stored.reply.status, Status::Ok);
    EXPECT_EQ(stored.reply.actual, 3U);
    EXPECT_EQ(rig_.await(client, client.controlIn({0xC0, Device::kEcho, 0, 0, 64}, 64)).data,
              (Bytes{1, 2, 3}));
    EXPECT_EQ(rig_.await(client, client.controlIn({0xC0, Device::kRefuse, 0, 0, 4}, 4)).reply.status,
              Status::Stall);
}

TEST_F(UsbipConversation, AControlTransferThatContradictsItselfIsInvalid) {
    RawClient& client = host();
    const auto lies = {client.controlOut({0x40, Device::kStore, 0, 0, 4}, {1, 2}),
                       client.controlIn({0x40, Device::kStore, 0, 0, 4}, 4),
                       client.controlOut({0xC0, Device::kEcho, 0, 0, 4})};
    for (const std::uint32_t sequence : lies)
        EXPECT_EQ(rig_.await(client, sequence).reply.status, Status::Invalid) << sequence;
    EXPECT_EQ(rig_.await(client, client.controlIn({0x40, Device::kStore, 0, 0, 0}, 0)).reply.status,
              Status::Ok)
        << "without bytes the direction says nothing";
    EXPECT_EQ(rig_.report().malformed, 0U);
}

TEST_F(UsbipConversation, InWaitsUntilThereIsSomething) {
    RawClient& client = host();
    const std::uint32_t sequence = client.in(Device::kFastIn, 64);
    rig_.advance(1h);
    EXPECT_EQ(client.answer(sequence), nullptr);
    device_.offer(Device::kFastIn, {7, 8});
    rig_.advance(1ms);
    ASSERT_NE(client.answer(sequence), nullptr);
    EXPECT_EQ(client.answer(sequence)->reply.status, Status::Ok);
    EXPECT_EQ(client.answer(sequence)->data, (Bytes{7, 8}));
}

TEST_F(UsbipConversation, OutGoesAPacketAMillisecond) {
    RawClient& client = host();
    const double start_ms = ms(rig_.scheduler().now());
    std::vector<std::uint32_t> sequences;
    for (std::uint8_t i = 0; i < 5; ++i)
        sequences.push_back(client.out(Device::kFastOut, {i}));
    rig_.advance(1s);
    for (std::size_t i = 0; i < sequences.size(); ++i) {
        ASSERT_NE(client.answer(sequences[i]), nullptr);
        EXPECT_DOUBLE_EQ(ms(client.answer(sequences[i])->time), start_ms + 1 + static_cast<double>(i));
        EXPECT_EQ(device_.received().at(i).bytes, Bytes{static_cast<std::uint8_t>(i)});
    }
}

TEST_F(UsbipConversation, LongTransfersTakeAPacketATurn) {
    RawClient& client = host();
    const TimePoint start = rig_.scheduler().now();
    const auto sent = rig_.await(client, client.out(Device::kBulkOut, packet(130)));
    EXPECT_EQ(sent.reply.actual, 130U);
    EXPECT_TRUE(sent.data.empty());
    EXPECT_EQ(sent.time - start, 3ms);
    ASSERT_EQ(device_.received().size(), 3U);
    EXPECT_EQ(device_.received()[2].bytes, (Bytes{128, 129}));

    const std::uint32_t sequence = client.in(Device::kBulkIn, 24);
    for (const std::size_t size : {8U, 8U, 3U})
        device_.offer(Device::kBulkIn, packet(size));
    device_.offer(Device::kBulkIn, {99});
    const auto got = rig_.await(client, sequence);
    EXPECT_EQ(got.data.size(), 19U) << "a short packet ends it";
    EXPECT_EQ(rig_.await(client, client.in(Device::kBulkIn, 8)).data, Bytes{99});
}

TEST_F(UsbipConversation, AFullLastPacketIsFollowedByAnEmptyOneOnlyWhereAskedFor) {
    RawClient& client = host();
    rig_.await(client, client.out(Device::kBulkOut, packet(64)));
    EXPECT_EQ(device_.received().size(), 1U);
    rig_.await(client, client.out(Device::kBulkOut, packet(64), usbip::kZeroPacketFlag));
    EXPECT_EQ(device_.received().size(), 3U);
    EXPECT_TRUE(device_.received().back().bytes.empty());
    rig_.await(client, client.out(Device::kBulkOut, packet(63), usbip::kZeroPacketFlag));
    rig_.await(client, client.out(Device::kBulkOut, {}, usbip::kZeroPacketFlag));
    EXPECT_EQ(device_.received().size(), 5U);
}

TEST_F(UsbipConversation, APacketLongerThanTheRoomOverflows) {
    RawClient& client = host();
    device_.offer(Device::kFastIn, packet(8));
    EXPECT_EQ(rig_.await(client, client.in(Device::kFastIn, 4)).reply.status, Status::Overflow);
}

TEST_F(UsbipConversation, AHaltedEndpointSaysStallUntilItIsCleared) {
    RawClient& client = host();
    device_.halt(Device::kFastIn);
    EXPECT_EQ(rig_.await(client, client.in(Device::kFastIn, 64)).reply.status, Status::Stall);
    EXPECT_EQ(rig_.await(client, client.controlOut({0x02, 1, 0, Device::kFastIn, 0})).reply.status,
              Status::Ok);
    device_.offer(Device::kFastIn, {5});
    EXPECT_EQ(rig_.await(client, client.in(Device::kFastIn, 64)).data, Bytes{5});
}

TEST_F(UsbipConversation, AnEndpointThatIsNotThereAnswersNothing) {
    RawClient& client = host();
    EXPECT_EQ(rig_.await(client, client.in(0x8A, 64)).reply.status, Status::Protocol);
    EXPECT_EQ(rig_.await(client, client.out(0x0A, {1})).reply.status, Status::Protocol);
}

TEST_F(UsbipConversation, AnUnlinkedTransferIsAnsweredByTheUnlinkAlone) {
    RawClient& client = host();
    const std::uint32_t waiting = client.in(Device::kFastIn, 64);
    const std::uint32_t kept = client.in(Device::kFastIn, 64);
    rig_.advance(5ms);
    const auto unlinked = rig_.await(client, client.unlink(waiting));
    EXPECT_EQ(unlinked.reply.kind, Kind::Unlink);
    EXPECT_EQ(unlinked.reply.status, Status::Reset);
    device_.offer(Device::kFastIn, {1});
    EXPECT_EQ(rig_.await(client, kept).data, Bytes{1});
    EXPECT_EQ(client.answer(waiting), nullptr);
    EXPECT_EQ(rig_.report().unlinked, 1U);
}

TEST_F(UsbipConversation, AnUnlinkInTheSameBreathStillComesInTime) {
    RawClient& client = host();
    const std::uint32_t sequence = client.out(Device::kFastOut, {1});
    EXPECT_EQ(rig_.await(client, client.unlink(sequence)).reply.status, Status::Reset);
    rig_.advance(1s);
    EXPECT_TRUE(device_.received().empty());
    EXPECT_EQ(client.answer(sequence), nullptr);
}

TEST_F(UsbipConversation, AnUnlinkOfWhatHasEndedSaysZeroAfterItsAnswer) {
    RawClient& client = host();
    const std::uint32_t sequence = client.out(Device::kFastOut, {1});
    rig_.await(client, sequence);
    const std::uint32_t first = client.unlink(sequence);
    const std::uint32_t second = client.unlink(sequence);
    EXPECT_EQ(rig_.await(client, first).reply.status, Status::Ok);
    EXPECT_EQ(rig_.await(client, second).reply.status, Status::Ok);
    EXPECT_EQ(rig_.await(client, client.unlink(12345)).reply.status, Status::Ok);
}

TEST_F(UsbipConversation, NoUnlinkOvertakesTheAnswerOfItsTransfer) {
    RawClient& client = host();
    const std::uint32_t sequence = client.in(0x8A, 4);  // Ends at once, and is told of a moment later.
    const std::uint32_t unlink = client.unlink(sequence);
    rig_.await(client, unlink);
    ASSERT_NE(client.answer(sequence), nullptr);
    EXPECT_LT(client.answer(sequence), client.answer(unlink));
}

TEST_F(UsbipConversation, AnUnlinkTwiceIsAnsweredTwice) {
    RawClient& client = host();
    const std::uint32_t waiting = client.in(Device::kFastIn, 64);
    const std::uint32_t first = client.unlink(waiting);
    const std::uint32_t second = client.unlink(waiting);
    EXPECT_EQ(rig_.await(client, first).reply.status, Status::Reset);
    EXPECT_EQ(rig_.await(client, second).reply.status, Status::Ok);
    EXPECT_EQ(client.answer(waiting), nullptr);
}

TEST_F(UsbipConversation, AnUnplugEndsAllThatWaitsAndThenTheConnection) {
    RawClient& client = host();
    device_.setBusy(true);
    const auto waiting = {client.in(Device::kFastIn, 64), client.in(Device::kSlowIn, 4),
                          client.out(Device::kFastOut, packet(64)),
                          client.controlIn({0xC0, Device::kIgnore, 0, 0, 4}, 4)};
    rig_.advance(20ms);
    device_.unplug();
    rig_.advance(0ms);
    for (const std::uint32_t sequence : waiting) {
        ASSERT_NE(client.answer(sequence), nullptr);
        EXPECT_EQ(client.answer(sequence)->reply.status, Status::Shutdown);
    }
    EXPECT_FALSE(rig_.inUse());
    EXPECT_FALSE(client.closed());
    rig_.advance(250ms);
    EXPECT_TRUE(client.closed());
    EXPECT_EQ(rig_.connections(), 0U);
    EXPECT_EQ(rig_.scheduler().pending(), 0U);
    device_.plug();
    host();
}

TEST_F(UsbipConversation, WhatIsAskedOfAnUnpluggedDeviceIsStillAnswered) {
    RawClient& client = host();
    const std::uint32_t waiting = client.in(Device::kFastIn, 64);
    rig_.advance(20ms);
    device_.unplug();
    rig_.advance(200ms);
    EXPECT_EQ(rig_.await(client, client.in(Device::kFastIn, 64)).reply.status, Status::Shutdown);
    EXPECT_EQ(rig_.await(client, client.out(Device::kFastOut, {1})).reply.status, Status::Shutdown);
    EXPECT_EQ(rig_.await(client, client.unlink(waiting)).reply.status, Status::Ok);
    rig_.advance(200ms);
    EXPECT_FALSE(client.closed()) << "it has asked a moment ago";
    device_.plug();
    EXPECT_EQ(rig_.await(client, client.in(Device::kFastIn, 64)).reply.status, Status::Shutdown)
        << "it has to import what is plugged in again";
    host();
    rig_.advance(250ms);
    EXPECT_TRUE(client.closed());
    EXPECT_TRUE(rig_.inUse());
}

TEST_F(UsbipConversation, AClientThatGoesOnAskingOfAnUnpluggedDeviceIsLetGoAllTheSame) {
    RawClient& client = host();
    device_.unplug();
    for (int i = 0; i < 19; ++i) {
        rig_.advance(100ms);
        client.in(Device::kFastIn, 64);
    }
    EXPECT_FALSE(client.closed());
    rig_.advance(100ms);
    EXPECT_TRUE(client.closed());
    EXPECT_EQ(rig_.scheduler().pending(), 0U);
}

TEST_F(UsbipConversation, AClientThatGoesLeavesNothingBehind) {
    RawClient& client = host();
    device_.setBusy(true);
    client.in(Device::kFastIn, 64);
    client.out(Device::kFastOut, {1});
    client.controlIn({0xC0, Device::kIgnore, 0, 0, 4}, 4);
    rig_.advance(5ms);
    client.close();
    rig_.advance(0ms);
    EXPECT_EQ(rig_.connections(), 0U);
    EXPECT_EQ(rig_.scheduler().pending(), 0U);
    device_.setBusy(false);
    rig_.advance(1s);
    EXPECT_TRUE(device_.received().empty()) << "sent after its client had gone";
    EXPECT_EQ(device_.configurations().back(), 0);
}

TEST_F(UsbipConversation, TheLogTellsClientsApart) {
    RawClient& client = host();
    RawClient& second = rig_.connect();
    second.import("1-2");
    rig_.advance(0ms);
    client.close();
    rig_.advance(0ms);
    EXPECT_EQ(rig_.log(), (std::vector<std::string>{
                              "client 1 imported 1-1",
                              "client 2 asked for a device that is not there",
                              "client 1 left",
                          }));
}

}  // namespace
}  // namespace kickstand::testing
