#include "tests/contract/usb_link_contract.h"

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

void UsbLinkContract::SetUp() {
    rig_ = GetParam().make();
    makeLink();
}

void UsbLinkContract::makeLink() {
    rig_->onLink([this] {
        link_.reset();
        link_ = rig_->makeLink();
        link_->setPresenceListener([this](bool present) { presence_.push_back(present); });
    });
}

void UsbLinkContract::TearDown() {
    destroy();
    rig_.reset();
}

void UsbLinkContract::destroy() {
    rig_->onLink([this] { link_.reset(); });
}

Result<UsbDeviceInfo> UsbLinkContract::tryOpen() {
    auto opened = std::make_shared<std::optional<Result<UsbDeviceInfo>>>();
    rig_->onLink(
        [&] { link_->open([opened](Result<UsbDeviceInfo> result) { *opened = std::move(result); }); });
    if (!rig_->waitUntil([&] { return opened->has_value(); })) return fail(Errc::TimedOut, "watchdog");
    return **opened;
}

UsbDeviceInfo UsbLinkContract::open() {
    const auto opened = tryOpen();
    EXPECT_TRUE(opened.has_value()) << name(opened.error().code) << " " << opened.error().detail;
    return opened.value_or(UsbDeviceInfo{});
}

void UsbLinkContract::close() {
    auto closed = std::make_shared<bool>(false);
    rig_->onLink([&] { link_->close([closed] { *closed = true; }); });
    ASSERT_TRUE(rig_->waitUntil([&] { return *closed; }));
}

UsbCallback UsbLinkContract::record(int number) {
    return [this, number](const UsbCompletion& completion) {
        Ending& ending = endings_[number];
        ++ending.calls;
        ending.status = completion.status;
        ending.data.assign(completion.data.begin(), completion.data.end());
        ending.actual = completion.actual;
        order_.push_back(number);
    };
}

int UsbLinkContract::out(std::uint8_t endpoint, Bytes bytes) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        const auto id = link_->submitOut(endpoint, bytes, record(number));
        ASSERT_TRUE(id.has_value()) << name(id.error().code);
        EXPECT_NE(*id, 0U);
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
        ids_[number] = *id;
    });
    return number;
}

int UsbLinkContract::in(std::uint8_t endpoint, std::size_t size) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        const auto id = link_->submitIn(endpoint, size, record(number));
        ASSERT_TRUE(id.has_value()) << name(id.error().code);
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
        ids_[number] = *id;
    });
    return number;
}

int UsbLinkContract::control(const UsbSetup& setup, Bytes bytes, Duration deadline) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        link_->control(setup, bytes, deadline, record(number));
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
    });
    return number;
}

int UsbLinkContract::clearHalt(std::uint8_t endpoint) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        link_->clearHalt(endpoint, record(number));
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
    });
    return number;
}

void UsbLinkContract::cancel(int number) {
    rig_->onLink([&] {
        const std::size_t before = order_.size();
        link_->cancel(ids_.at(number));
        EXPECT_EQ(order_.size(), before) << "called back from inside the call";
    });
}

Ending UsbLinkContract::ending(int number) {
    Ending found;
    rig_->onLink([&] {
        if (const auto known = endings_.find(number); known != endings_.end()) found = known->second;
    });
    return found;
}

Ending UsbLinkContract::finished(int number) {
    EXPECT_TRUE(rig_->waitUntil([&] { return endings_.contains(number); })) << "transfer never ended";
    return ending(number);
}

bool UsbLinkContract::waitForPresence(std::size_t changes) {
    return rig_->waitUntil([&] { return presence_.size() >= changes; });
}

std::vector<Device::Packet> UsbLinkContract::received() {
    std::vector<Device::Packet> packets;
    rig_->onDevice([&](Device& device) { packets = device.received(); });
    return packets;
}

TEST_P(UsbLinkContract, OpenTellsWhatTheDeviceIs) {
    const UsbDeviceInfo info = open();
    EXPECT_EQ(info.vendor, Device::kVendor);
    EXPECT_EQ(info.product, Device::kProduct);
    EXPECT_EQ(info.release, 0x0123);
    EXPECT_EQ(info.manufacturer, "Bench works");
    EXPECT_EQ(info.productName, "Fake device");
    EXPECT_EQ(info.port, "1-1");
}

TEST_P(UsbLinkContract, OpenStartsTheDeviceAfresh) {
    rig_->onDevice([](Device& device) { device.offer(Device::kFastIn, {0xEE}); });
    open();
    rig_->onDevice([](Device& device) {
        ASSERT_GE(device.configurations().size(), 2U);
        EXPECT_EQ(device.configurations()[device.configurations().size() - 2], 0);
        EXPECT_EQ(device.configurations().back(), 1);
        device.offer(Device::kFastIn, {0x01});
    });
    EXPECT_EQ(finished(in(Device::kFastIn, 64)).data, Bytes{0x01}) << "an earlier program's packet survived";
}

TEST_P(UsbLinkContract, OpenWithoutDeviceSaysSo) {
    rig_->onDevice([](Device& device) { device.unplug(); });
    makeLink();
    const auto opened = tryOpen();
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::NoDevice);
}

TEST_P(UsbLinkContract, OpeningAnOpenLinkIsRefusedAndHarmless) {
    open();
    const auto again = tryOpen();
    ASSERT_FALSE(again.has_value());
    EXPECT_EQ(again.error().code, Errc::BadArgument);
    EXPECT_EQ(finished(out(Device::kFastOut, {1})).status, UsbStatus::Completed);
}

TEST_P(UsbLinkContract, CloseDuringOpenEndsBoth) {
    std::vector<std::string> heard;
    rig_->onLink([&] {
        link_->open([&](Result<UsbDeviceInfo> opened) {
            heard.emplace_back(opened ? "opened" : name(opened.error().code));
        });
        link_->close([&] { heard.emplace_back("closed"); });
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return heard.size() == 2; }));
    EXPECT_EQ(heard, (std::vector<std::string>{"cancelled", "closed"}));
    open();
}

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

TEST_P(UsbLinkContract, CloseEndsEverythingOnceAndThenSaysSo) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    std::vector<int> pending{in(Device::kFastIn, 64),    in(Device::kFastIn, 64),
                             in(Device::kSlowIn, 4),     out(Device::kFastOut, {1}),
                             out(Device::kFastOut, {2}), control(vendorIn(Device::kIgnore, 4), {})};
    std::optional<std::size_t> endedBefore;
    rig_->onLink([&] { link_->close([&] { endedBefore = order_.size(); }); });
    ASSERT_TRUE(rig_->waitUntil([&] { return endedBefore.has_value(); }));
    EXPECT_EQ(endedBefore, pending.size()) << "done came before the last callback";
    rig_->settle();
    for (const int number : pending) {
        EXPECT_EQ(ending(number).calls, 1);
        EXPECT_EQ(ending(number).status, UsbStatus::Cancelled);
    }
    rig_->onLink([&] { EXPECT_TRUE(presence_.empty()) << "closing is not losing"; });
}

TEST_P(UsbLinkContract, CloseOfAClosedLinkComesBack) {
    close();
    open();
    close();
    close();
}

TEST_P(UsbLinkContract, AClosedLinkOpensAgain) {
    for (int round = 0; round < 5; ++round) {
        open();
        EXPECT_EQ(finished(out(Device::kFastOut, {static_cast<std::uint8_t>(round)})).status,
                  UsbStatus::Completed);
        close();
    }
    EXPECT_EQ(received().size(), 5U);
}

TEST_P(UsbLinkContract, UnplugEndsEverythingWithNoDeviceAndThenSaysSo) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    std::vector<int> pending{in(Device::kFastIn, 64), in(Device::kSlowIn, 4), out(Device::kFastOut, {1}),
                             out(Device::kFastOut, {2}), control(vendorIn(Device::kIgnore, 4), {})};
    std::optional<std::size_t> endedBefore;
    rig_->onLink([&] {
        link_->setPresenceListener([&](bool present) {
            presence_.push_back(present);
            endedBefore = order_.size();
        });
    });
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->settle();
    EXPECT_EQ(endedBefore, pending.size()) << "told before the last callback";
    for (const int number : pending) {
        EXPECT_EQ(ending(number).calls, 1);
        EXPECT_EQ(ending(number).status, UsbStatus::NoDevice);
    }
    rig_->onLink([&] {
        EXPECT_EQ(presence_, std::vector<bool>{false});
        EXPECT_EQ(link_->submitOut(Device::kFastOut, {}, {}).error().code, Errc::NotConnected);
    });
    EXPECT_FALSE(tryOpen().has_value());
}

TEST_P(UsbLinkContract, UnplugWithNothingPendingIsNoticed) {
    open();
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->onLink([&] { EXPECT_EQ(presence_, std::vector<bool>{false}); });
}

TEST_P(UsbLinkContract, AReplugIsToldAndTheLinkOpensAgain) {
    open();
    for (std::size_t round = 0; round < 3; ++round) {
        const int waiting = in(Device::kFastIn, 64);
        rig_->onDevice([](Device& device) { device.unplug(); });
        ASSERT_TRUE(waitForPresence(2 * round + 1));
        EXPECT_EQ(ending(waiting).status, UsbStatus::NoDevice);
        rig_->onDevice([](Device& device) { device.plug(); });
        ASSERT_TRUE(waitForPresence(2 * round + 2));
        open();
        EXPECT_EQ(finished(out(Device::kFastOut, {1})).status, UsbStatus::Completed);
    }
    rig_->onLink([&] { EXPECT_EQ(presence_, (std::vector<bool>{false, true, false, true, false, true})); });
}

TEST_P(UsbLinkContract, ADeviceThatAppearsIsToldBeforeTheFirstOpen) {
    rig_->onDevice([](Device& device) { device.unplug(); });
    makeLink();
    EXPECT_FALSE(tryOpen().has_value());
    rig_->onDevice([](Device& device) { device.plug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->onLink(
        [&] { EXPECT_EQ(presence_, std::vector<bool>{true}) << "a link that is not open loses nothing"; });
    open();
}

TEST_P(UsbLinkContract, UnplugDuringOpenEndsIt) {
    std::optional<bool> opened;
    rig_->onLink([&] { link_->open([&](Result<UsbDeviceInfo> result) { opened = result.has_value(); }); });
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(rig_->waitUntil([&] { return opened.has_value(); }));
    if (*opened) {
        ASSERT_TRUE(waitForPresence(1));
    }
    rig_->onDevice([](Device& device) { device.plug(); });
    ASSERT_TRUE(rig_->waitUntil([&] { return !presence_.empty() && presence_.back(); }));
    open();
}

TEST_P(UsbLinkContract, DestroyWithTransfersPendingSilencesThem) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    const std::vector<int> pending{in(Device::kFastIn, 64), out(Device::kFastOut, {1}),
                                   control(vendorIn(Device::kIgnore, 4), {})};
    destroy();
    rig_->onDevice([](Device& device) { device.setBusy(false); });
    rig_->settle();
    for (const int number : pending)
        EXPECT_EQ(ending(number).calls, 0);
}

TEST_P(UsbLinkContract, DestroyDuringOpenIsSilent) {
    bool called = false;
    rig_->onLink([&] {
        link_->open([&](const Result<UsbDeviceInfo>&) { called = true; });
        link_.reset();
    });
    rig_->settle();
    rig_->onLink([&] { EXPECT_FALSE(called); });
}

TEST_P(UsbLinkContract, DestroyDuringCloseIsSilent) {
    open();
    const int waiting = in(Device::kFastIn, 64);
    bool closed = false;
    rig_->onLink([&] {
        link_->close([&] { closed = true; });
        link_.reset();
    });
    rig_->settle();
    rig_->onLink([&] { EXPECT_FALSE(closed); });
    EXPECT_EQ(ending(waiting).calls, 0);
}

TEST_P(UsbLinkContract, DestroyWhileTheDeviceVanishesIsSilent) {
    open();
    const int waiting = in(Device::kFastIn, 64);
    rig_->onDevice([](Device& device) { device.unplug(); });
    destroy();
    rig_->settle();
    EXPECT_LE(ending(waiting).calls, 1);
}

TEST_P(UsbLinkContract, ACallbackMayDestroyTheLink) {
    open();
    const int other = in(Device::kSlowIn, 4);
    bool called = false;
    rig_->onLink([&] {
        ASSERT_TRUE(link_->submitOut(Device::kFastOut, Bytes{1}, [&](const UsbCompletion&) {
            link_.reset();
            called = true;
        }));
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return called; }));
    rig_->settle();
    EXPECT_EQ(ending(other).calls, 0);
}

TEST_P(UsbLinkContract, ThePresenceListenerMayDestroyTheLink) {
    open();
    rig_->onLink([&] {
        link_->setPresenceListener([&](bool present) {
            link_.reset();
            presence_.push_back(present);
        });
    });
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->settle();
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

TEST_P(UsbLinkContract, ACallbackMayClose) {
    open();
    bool closed = false;
    const int waiting = in(Device::kFastIn, 64);
    rig_->onLink([&] {
        ASSERT_TRUE(link_->submitOut(Device::kFastOut, Bytes{1},
                                     [&](const UsbCompletion&) { link_->close([&] { closed = true; }); }));
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return closed; }));
    EXPECT_EQ(ending(waiting).status, UsbStatus::Cancelled);
}

}  // namespace kickstand::testing
