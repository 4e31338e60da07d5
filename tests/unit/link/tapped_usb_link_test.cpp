#include "core/link/tapped_usb_link.h"

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/link/loopback/loopback_usb_link.h"
#include "tests/support/usb/fake_usb_device.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using Device = testing::FakeUsbDevice;
using Kind = UsbTapRecord::Kind;
using Bytes = std::vector<std::uint8_t>;

/// A record with its bytes copied, as an observer keeps it.
struct Kept {
    UsbTapRecord record;
    Bytes data;
};

class Recorder : public UsbTapObserver {
  public:
    void observe(const UsbTapRecord& record) override {
        kept.push_back({record, {record.data.begin(), record.data.end()}});
        if (onRecord) onRecord();
    }
    std::vector<Kept> kept;
    std::function<void()> onRecord;
};

class Tap : public ::testing::Test {
  protected:
    Tap() { link_.addObserver(&recorder_); }

    void open() {
        link_.open([](const Result<UsbDeviceInfo>& opened) { ASSERT_TRUE(opened); });
        scheduler_.advance(10ms);
    }
    /// What was recorded since the last call.
    std::vector<Kept> take() { return std::exchange(recorder_.kept, {}); }

    FakeScheduler scheduler_;
    Device device_;
    Recorder recorder_;
    TappedUsbLink link_{std::make_unique<LoopbackUsbLink>(scheduler_, device_), scheduler_};
};

TEST_F(Tap, ShowsOpeningClosingAndLosing) {
    open();
    bool closed = false;
    link_.close([&] { closed = true; });
    scheduler_.advance(1ms);
    EXPECT_TRUE(closed);
    link_.close([] {});
    scheduler_.advance(1ms);
    open();
    device_.unplug();
    scheduler_.advance(1ms);
    device_.plug();
    scheduler_.advance(1ms);
    const auto kept = take();
    ASSERT_EQ(kept.size(), 4U) << "closing a closed link is nothing to record";
    EXPECT_EQ(kept[0].record.kind, Kind::Opened);
    EXPECT_EQ(kept[0].record.time, TimePoint(2ms));
    EXPECT_EQ(kept[1].record.kind, Kind::Closed);
    EXPECT_EQ(kept[2].record.kind, Kind::Opened);
    EXPECT_EQ(kept[3].record.kind, Kind::Lost);
    EXPECT_EQ(kept[3].record.status, UsbStatus::NoDevice);
}

TEST_F(Tap, AFailedOpenIsNoOpening) {
    device_.unplug();
    link_.open([](const Result<UsbDeviceInfo>& opened) { EXPECT_FALSE(opened); });
    scheduler_.advance(10ms);
    EXPECT_TRUE(take().empty());
}

TEST_F(Tap, ShowsOutPacketsWhenSubmittedAndWhenCompleted) {
    open();
    take();
    ASSERT_TRUE(link_.submitOut(Device::kFastOut, Bytes{1, 2, 3}, {}));
    ASSERT_TRUE(link_.submitOut(Device::kFastOut, {}, {}));
    scheduler_.advance(5ms);
    const auto kept = take();
    ASSERT_EQ(kept.size(), 4U);
    EXPECT_EQ(kept[0].record.kind, Kind::Submitted);
    EXPECT_EQ(kept[0].record.time, TimePoint(10ms));
    EXPECT_EQ(kept[0].record.endpoint, Device::kFastOut);
    EXPECT_EQ(kept[0].data, (Bytes{1, 2, 3}));
    EXPECT_EQ(kept[1].record.kind, Kind::Submitted);
    EXPECT_TRUE(kept[1].data.empty());
    EXPECT_EQ(kept[2].record.kind, Kind::Completed);
    EXPECT_EQ(kept[2].record.time, TimePoint(11ms));
    EXPECT_EQ(kept[2].record.status, UsbStatus::Completed);
    EXPECT_EQ(kept[2].record.actual, 3U);
    EXPECT_EQ(kept[2].data, (Bytes{1, 2, 3}));
    EXPECT_EQ(kept[2].record.id, kept[0].record.id);
    EXPECT_EQ(kept[3].record.id, kept[1].record.id);
    EXPECT_NE(kept[0].record.id, kept[1].record.id);
    EXPECT_NE(kept[0].record.id, 0U);
}

TEST_F(Tap, ShowsInPacketsWhenTheyCome) {
    open();
    take();
    ASSERT_TRUE(link_.submitIn(Device::kFastIn, 64, {}));
    scheduler_.advance(5ms);
    EXPECT_TRUE(take().empty());
    device_.offer(Device::kFastIn, {7, 8});
    scheduler_.advance(5ms);
    const auto kept = take();
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_EQ(kept[0].record.kind, Kind::Completed);
    EXPECT_EQ(kept[0].record.endpoint, Device::kFastIn);
    EXPECT_EQ(kept[0].record.id, 0U);
    EXPECT_EQ(kept[0].data, (Bytes{7, 8}));
}

TEST_F(Tap, ShowsControlTransfersWithTheirSetup) {
    open();
    take();
    const UsbSetup store{0x40, Device::kStore, 0, 0, 2};
    const UsbSetup echo{0xC0, Device::kEcho, 0, 0, 64};
    link_.control(store, Bytes{4, 5}, 1s, {});
    link_.control(echo, {}, 1s, {});
    scheduler_.advance(5ms);
    const auto kept = take();
    ASSERT_EQ(kept.size(), 4U);
    EXPECT_EQ(kept[0].record.kind, Kind::Submitted);
    EXPECT_EQ(kept[0].record.setup, store);
    EXPECT_EQ(kept[0].data, (Bytes{4, 5}));
    EXPECT_EQ(kept[1].record.setup, echo);
    EXPECT_EQ(kept[2].record.kind, Kind::Completed);
    EXPECT_EQ(kept[2].record.setup, store);
    EXPECT_EQ(kept[2].data, (Bytes{4, 5}));
    EXPECT_EQ(kept[2].record.id, kept[0].record.id);
    EXPECT_EQ(kept[3].data, (Bytes{4, 5}));
    EXPECT_EQ(kept[3].record.actual, 2U);
}

TEST_F(Tap, ShowsTheClearingOfAHaltAsWhatItIsOnTheWire) {
    open();
    take();
    link_.clearHalt(Device::kFastIn, {});
    scheduler_.advance(5ms);
    const auto kept = take();
    ASSERT_EQ(kept.size(), 2U);
    EXPECT_EQ(kept[0].record.setup, (UsbSetup{0x02, 1, 0, Device::kFastIn, 0}));
    EXPECT_EQ(kept[1].record.status, UsbStatus::Completed);
}

TEST_F(Tap, ShowsHowTransfersFail) {
    open();
    take();
    device_.halt(Device::kFastIn);
    ASSERT_TRUE(link_.submitIn(Device::kFastIn, 64, {}));
    link_.control({0xC0, Device::kIgnore, 0, 0, 4}, {}, 3ms, {});
    const auto waiting = link_.submitIn(Device::kSlowIn, 4, {});
    link_.cancel(*waiting);
    scheduler_.advance(5ms);
    const auto kept = take();
    ASSERT_EQ(kept.size(), 4U);
    EXPECT_EQ(kept[1].record.status, UsbStatus::Cancelled);
    EXPECT_EQ(kept[2].record.status, UsbStatus::Stalled);
    EXPECT_EQ(kept[3].record.status, UsbStatus::TimedOut);
}

TEST_F(Tap, ARefusedPacketIsNotRecorded) {
    open();
    take();
    EXPECT_FALSE(link_.submitOut(Device::kFastOut, Bytes(65), {}));
    EXPECT_FALSE(link_.submitOut(0x01, {}, {}));
    scheduler_.advance(5ms);
    EXPECT_TRUE(take().empty());
}

TEST_F(Tap, ACompletionIsSeenBeforeItsCallback) {
    open();
    std::size_t seen = 0;
    take();
    ASSERT_TRUE(
        link_.submitOut(Device::kFastOut, {}, [&](const UsbCompletion&) { seen = recorder_.kept.size(); }));
    scheduler_.advance(5ms);
    EXPECT_EQ(seen, 2U);
}

TEST_F(Tap, ObserversAreToldInTheirOrderUntilTheyAreRemoved) {
    open();
    Recorder second;
    std::vector<int> order;
    recorder_.onRecord = [&] { order.push_back(1); };
    second.onRecord = [&] { order.push_back(2); };
    link_.addObserver(&second);
    link_.clearHalt(Device::kFastIn, {});
    EXPECT_EQ(order, (std::vector<int>{1, 2}));
    link_.removeObserver(&recorder_);
    scheduler_.advance(5ms);
    EXPECT_EQ(order, (std::vector<int>{1, 2, 2}));
    link_.removeObserver(&second);
}

TEST_F(Tap, AnObserverMayRemoveItselfWhileItIsTold) {
    open();
    Recorder second;
    link_.addObserver(&second);
    take();
    recorder_.onRecord = [&] { link_.removeObserver(&recorder_); };
    link_.clearHalt(Device::kFastIn, {});
    scheduler_.advance(5ms);
    EXPECT_EQ(recorder_.kept.size(), 1U);
    EXPECT_EQ(second.kept.size(), 2U) << "the next observer was skipped";
    link_.removeObserver(&second);
}

}  // namespace
}  // namespace kickstand
