#include "tests/contract/usb_link_contract.h"

// What becomes of transfers on an open link.

namespace kickstand::testing {

using namespace std::chrono_literals;
using Device = FakeUsbDevice;
using Bytes = std::vector<std::uint8_t>;

namespace {

UsbSetup vendorIn(std::uint8_t request, std::uint16_t length) {
    return {0xC0, request, 0, 0, length};
}
UsbSetup vendorOut(std::uint8_t request, std::uint16_t length) {
    return {0x40, request, 0, 0, length};
}

Bytes packet(std::size_t size, std::uint8_t first = 0) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<std::uint8_t>(first + i);
    return bytes;
}

}  // namespace

TEST_P(UsbLinkContract, NothingCanBeSubmittedWhileClosed) {
    rig_->onLink([&] {
        EXPECT_EQ(link_->submitOut(Device::kFastOut, {}, record(100)).error().code, Errc::NotConnected);
        EXPECT_EQ(link_->submitIn(Device::kFastIn, 64, record(101)).error().code, Errc::NotConnected);
    });
    EXPECT_EQ(finished(control(vendorIn(Device::kEcho, 4), {})).status, UsbStatus::NoDevice);
    EXPECT_EQ(finished(clearHalt(Device::kFastIn)).status, UsbStatus::NoDevice);
    EXPECT_EQ(ending(100).calls, 0);
    EXPECT_EQ(ending(101).calls, 0);
}

TEST_P(UsbLinkContract, OutPacketsArriveInOrder) {
    open();
    std::vector<int> numbers;
    std::vector<Device::Packet> sent;
    for (std::uint8_t i = 0; i < 40; ++i) {
        sent.push_back({Device::kFastOut, packet(i, i)});
        numbers.push_back(out(Device::kFastOut, sent.back().bytes));
    }
    for (const int number : numbers) {
        const Ending ended = finished(number);
        EXPECT_EQ(ended.status, UsbStatus::Completed);
        EXPECT_EQ(ended.actual, sent[static_cast<std::size_t>(number - numbers.front())].bytes.size());
        EXPECT_TRUE(ended.data.empty());
    }
    EXPECT_EQ(received(), sent);
    rig_->onLink([&] { EXPECT_EQ(order_, numbers); });
}

TEST_P(UsbLinkContract, AnEmptyOutPacketIsAPacket) {
    open();
    const Ending ended = finished(out(Device::kFastOut, {}));
    EXPECT_EQ(ended.status, UsbStatus::Completed);
    EXPECT_EQ(ended.actual, 0U);
    EXPECT_EQ(received(), (std::vector<Device::Packet>{{Device::kFastOut, {}}}));
}

TEST_P(UsbLinkContract, BulkPacketsGoBothWays) {
    open();
    EXPECT_EQ(finished(out(Device::kBulkOut, packet(64))).status, UsbStatus::Completed);
    EXPECT_EQ(received(), (std::vector<Device::Packet>{{Device::kBulkOut, packet(64)}}));
    rig_->onDevice([](Device& device) { device.offer(Device::kBulkIn, packet(8)); });
    EXPECT_EQ(finished(in(Device::kBulkIn, 8)).data, packet(8));
}

TEST_P(UsbLinkContract, OutWaitsWhileTheDeviceIsBusy) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    const int first = out(Device::kFastOut, {1});
    const int second = out(Device::kFastOut, {2});
    rig_->settle();
    EXPECT_EQ(ending(first).calls, 0);
    rig_->onDevice([](Device& device) { device.setBusy(false); });
    EXPECT_EQ(finished(first).status, UsbStatus::Completed);
    EXPECT_EQ(finished(second).status, UsbStatus::Completed);
    EXPECT_EQ(received(), (std::vector<Device::Packet>{{Device::kFastOut, {1}}, {Device::kFastOut, {2}}}));
}

TEST_P(UsbLinkContract, InPacketsComeInOrderOneATransfer) {
    open();
    rig_->onDevice([](Device& device) {
        device.offer(Device::kFastIn, {1, 2, 3});
        device.offer(Device::kFastIn, {});
        device.offer(Device::kFastIn, packet(64));
    });
    const int first = in(Device::kFastIn, 64);
    const int second = in(Device::kFastIn, 64);
    const int third = in(Device::kFastIn, 64);
    EXPECT_EQ(finished(first).data, (Bytes{1, 2, 3}));
    EXPECT_EQ(ending(first).actual, 3U);
    EXPECT_EQ(finished(second).status, UsbStatus::Completed);
    EXPECT_TRUE(ending(second).data.empty());
    EXPECT_EQ(finished(third).data, packet(64));
}

TEST_P(UsbLinkContract, InWaitsForThePacket) {
    open();
    const int slow = in(Device::kSlowIn, 4);
    const int fast = in(Device::kFastIn, 64);
    rig_->settle();
    EXPECT_EQ(ending(slow).calls, 0);
    EXPECT_EQ(ending(fast).calls, 0);
    rig_->onDevice([](Device& device) { device.offer(Device::kSlowIn, {9, 8, 7, 6}); });
    EXPECT_EQ(finished(slow).data, (Bytes{9, 8, 7, 6}));
    EXPECT_EQ(ending(fast).calls, 0);
}

TEST_P(UsbLinkContract, APacketLongerThanAskedForOverflows) {
    open();
    rig_->onDevice([](Device& device) { device.offer(Device::kFastIn, packet(8)); });
    EXPECT_EQ(finished(in(Device::kFastIn, 4)).status, UsbStatus::Overflow);
}

TEST_P(UsbLinkContract, CancelEndsAWaitingTransferOnce) {
    open();
    const int cancelled = in(Device::kFastIn, 64);
    const int kept = in(Device::kFastIn, 64);
    cancel(cancelled);
    EXPECT_EQ(finished(cancelled).status, UsbStatus::Cancelled);
    cancel(cancelled);
    rig_->onDevice([](Device& device) { device.offer(Device::kFastIn, {5}); });
    EXPECT_EQ(finished(kept).data, Bytes{5});
    rig_->settle();
    EXPECT_EQ(ending(cancelled).calls, 1);
}

TEST_P(UsbLinkContract, CancelTwiceAndOfNothingIsHarmless) {
    open();
    const int waiting = in(Device::kFastIn, 64);
    rig_->onLink([&] {
        link_->cancel(ids_.at(waiting));
        link_->cancel(ids_.at(waiting));
        link_->cancel(0);
        link_->cancel(ids_.at(waiting) + 1000);
    });
    EXPECT_EQ(finished(waiting).status, UsbStatus::Cancelled);
    rig_->settle();
    EXPECT_EQ(ending(waiting).calls, 1);
}

TEST_P(UsbLinkContract, ACancelledOutPacketIsNotSent) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    const int first = out(Device::kFastOut, {1});
    const int second = out(Device::kFastOut, {2});
    cancel(first);
    EXPECT_EQ(finished(first).status, UsbStatus::Cancelled);
    rig_->onDevice([](Device& device) { device.setBusy(false); });
    EXPECT_EQ(finished(second).status, UsbStatus::Completed);
    EXPECT_EQ(received(), (std::vector<Device::Packet>{{Device::kFastOut, {2}}}));
}

TEST_P(UsbLinkContract, AHaltedEndpointStallsUntilCleared) {
    open();
    rig_->onDevice([](Device& device) { device.halt(Device::kFastIn); });
    EXPECT_EQ(finished(in(Device::kFastIn, 64)).status, UsbStatus::Stalled);
    EXPECT_EQ(finished(in(Device::kFastIn, 64)).status, UsbStatus::Stalled);
    EXPECT_EQ(finished(clearHalt(Device::kFastIn)).status, UsbStatus::Completed);
    rig_->onDevice([](Device& device) { device.offer(Device::kFastIn, {7}); });
    EXPECT_EQ(finished(in(Device::kFastIn, 64)).data, Bytes{7});
}

TEST_P(UsbLinkContract, AnOutEndpointCanHaltToo) {
    open();
    rig_->onDevice([](Device& device) { device.halt(Device::kFastOut); });
    EXPECT_EQ(finished(out(Device::kFastOut, {1})).status, UsbStatus::Stalled);
    EXPECT_EQ(finished(clearHalt(Device::kFastOut)).status, UsbStatus::Completed);
    EXPECT_EQ(finished(out(Device::kFastOut, {2})).status, UsbStatus::Completed);
    EXPECT_EQ(received(), (std::vector<Device::Packet>{{Device::kFastOut, {2}}}));
}

TEST_P(UsbLinkContract, AStallWhileWaitingEndsTheTransfer) {
    open();
    const int waiting = in(Device::kFastIn, 64);
    rig_->settle();
    rig_->onDevice([](Device& device) { device.halt(Device::kFastIn); });
    EXPECT_EQ(finished(waiting).status, UsbStatus::Stalled);
}

TEST_P(UsbLinkContract, ClearingAnEndpointThatIsNotThereFails) {
    open();
    EXPECT_EQ(finished(clearHalt(0x8A)).status, UsbStatus::Failed);
}

TEST_P(UsbLinkContract, ControlTransfersCarryBytesBothWays) {
    open();
    const Bytes bytes{1, 2, 3, 4, 5};
    const Ending stored = finished(control(vendorOut(Device::kStore, 5), bytes));
    EXPECT_EQ(stored.status, UsbStatus::Completed);
    EXPECT_EQ(stored.actual, 5U);
    EXPECT_TRUE(stored.data.empty());
    const Ending echoed = finished(control(vendorIn(Device::kEcho, 64), {}));
    EXPECT_EQ(echoed.status, UsbStatus::Completed);
    EXPECT_EQ(echoed.data, bytes);
    EXPECT_EQ(finished(control(vendorIn(Device::kEcho, 2), {})).data, (Bytes{1, 2}));
}

TEST_P(UsbLinkContract, AControlTransferWithoutDataCompletes) {
    open();
    EXPECT_EQ(finished(control(vendorOut(Device::kStore, 0), {})).status, UsbStatus::Completed);
}

TEST_P(UsbLinkContract, AControlTransferWhoseLengthLiesFails) {
    open();
    EXPECT_EQ(finished(control(vendorOut(Device::kStore, 4), {1, 2})).status, UsbStatus::Failed);
}

TEST_P(UsbLinkContract, ARefusedControlTransferStallsAndTheNextWorks) {
    open();
    EXPECT_EQ(finished(control(vendorIn(Device::kRefuse, 4), {})).status, UsbStatus::Stalled);
    EXPECT_EQ(finished(control(vendorOut(Device::kRefuse, 1), {1})).status, UsbStatus::Stalled);
    EXPECT_EQ(finished(control(vendorOut(Device::kStore, 1), {1})).status, UsbStatus::Completed);
}

TEST_P(UsbLinkContract, ControlTransfersEndAtTheirDeadline) {
    open();
    const int ignored = control(vendorIn(Device::kIgnore, 4), {}, 30ms);
    EXPECT_EQ(finished(ignored).status, UsbStatus::TimedOut);
    EXPECT_EQ(finished(control(vendorOut(Device::kStore, 1), {1})).status, UsbStatus::Completed);
    rig_->settle();
    EXPECT_EQ(ending(ignored).calls, 1);
}

TEST_P(UsbLinkContract, EndpointsThatAreNotThereAreRefused) {
    open();
    rig_->onLink([&] {
        for (const std::uint8_t endpoint : Bytes{0x00, 0x01, 0x0F, Device::kFastIn}) {
            const auto submitted = link_->submitOut(endpoint, Bytes{1}, record(200));
            ASSERT_FALSE(submitted.has_value()) << int{endpoint};
            EXPECT_EQ(submitted.error().code, Errc::BadArgument);
            EXPECT_EQ(submitted.error().endpoint, endpoint);
        }
        for (const std::uint8_t endpoint : Bytes{0x80, 0x8F, Device::kFastOut}) {
            const auto submitted = link_->submitIn(endpoint, 4, record(200));
            ASSERT_FALSE(submitted.has_value()) << int{endpoint};
            EXPECT_EQ(submitted.error().code, Errc::BadArgument);
        }
    });
    rig_->settle();
    EXPECT_EQ(ending(200).calls, 0);
}

TEST_P(UsbLinkContract, PacketsOfAnImpossibleSizeAreRefused) {
    open();
    rig_->onLink([&] {
        const auto tooLong = link_->submitOut(Device::kFastOut, packet(65), record(201));
        ASSERT_FALSE(tooLong.has_value());
        EXPECT_EQ(tooLong.error().code, Errc::OutOfRange);
        EXPECT_EQ(tooLong.error().highest, 64);
        EXPECT_EQ(tooLong.error().got, 65);
        EXPECT_EQ(link_->submitIn(Device::kSlowIn, 5, record(201)).error().code, Errc::OutOfRange);
        EXPECT_EQ(link_->submitIn(Device::kSlowIn, 0, record(201)).error().code, Errc::OutOfRange);
    });
    rig_->settle();
    EXPECT_EQ(ending(201).calls, 0);
    EXPECT_TRUE(received().empty());
}

TEST_P(UsbLinkContract, ACallbackMayAskForTheNextTransfer) {
    open();
    constexpr int kRounds = 20;
    int rounds = 0;
    std::function<void()> next = [&] {
        ASSERT_TRUE(link_->submitOut(Device::kFastOut, Bytes{static_cast<std::uint8_t>(rounds)},
                                     [&](const UsbCompletion&) {
                                         if (++rounds < kRounds) next();
                                     }));
    };
    rig_->onLink(next);
    ASSERT_TRUE(rig_->waitUntil([&] { return rounds == kRounds; }));
    EXPECT_EQ(received().size(), static_cast<std::size_t>(kRounds));
}

}  // namespace kickstand::testing
