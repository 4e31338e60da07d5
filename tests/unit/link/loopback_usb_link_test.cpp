#include "core/link/loopback/loopback_usb_link.h"

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "tests/support/usb/fake_usb_device.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using Device = testing::FakeUsbDevice;

/// The pace of the bus, which the contract leaves open.
class LoopbackPace : public ::testing::Test {
  protected:
    void open(const LoopbackOptions& options = {}) {
        link_ = std::make_unique<LoopbackUsbLink>(scheduler_, device_, options);
        link_->open([](const Result<UsbDeviceInfo>& opened) { ASSERT_TRUE(opened); });
        scheduler_.advance(10ms);
    }
    UsbCallback stamp(std::vector<double>& times_ms) {
        return [this, &times_ms](const UsbCompletion&) { times_ms.push_back(now_ms()); };
    }
    double now_ms() const { return seconds(scheduler_.now() - TimePoint()) * 1000; }

    FakeScheduler scheduler_;
    Device device_;
    std::unique_ptr<LoopbackUsbLink> link_;
};

TEST_F(LoopbackPace, AnEndpointMovesOnePacketAFrame) {
    open();
    std::vector<double> times_ms;
    scheduler_.advance(300us);
    for (int i = 0; i < 4; ++i)
        ASSERT_TRUE(link_->submitOut(Device::kFastOut, {}, stamp(times_ms)));
    scheduler_.advance(10ms);
    EXPECT_EQ(times_ms, (std::vector<double>{11, 12, 13, 14})) << "frames are the clock's milliseconds";
}

TEST_F(LoopbackPace, EndpointsShareTheFrame) {
    open();
    std::vector<double> out_ms;
    std::vector<double> bulk_ms;
    std::vector<double> control_ms;
    ASSERT_TRUE(link_->submitOut(Device::kFastOut, {}, stamp(out_ms)));
    ASSERT_TRUE(link_->submitOut(Device::kBulkOut, {}, stamp(bulk_ms)));
    link_->control({0x40, Device::kStore, 0, 0, 0}, {}, 1s, stamp(control_ms));
    link_->control({0x40, Device::kStore, 0, 0, 0}, {}, 1s, stamp(control_ms));
    scheduler_.advance(10ms);
    EXPECT_EQ(out_ms, std::vector<double>{11});
    EXPECT_EQ(bulk_ms, std::vector<double>{11});
    EXPECT_EQ(control_ms, (std::vector<double>{11, 12}));
}

TEST_F(LoopbackPace, ASlowEndpointIsPolledAtItsInterval) {
    open();
    std::vector<double> times_ms;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(link_->submitIn(Device::kSlowIn, 4, stamp(times_ms)));
        device_.offer(Device::kSlowIn, {1});
    }
    scheduler_.advance(100ms);
    EXPECT_EQ(times_ms, (std::vector<double>{25, 50, 75}));
}

TEST_F(LoopbackPace, ABenchMayPollInEveryFrame) {
    open({.everyFrame = true});
    std::vector<double> times_ms;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(link_->submitIn(Device::kSlowIn, 4, stamp(times_ms)));
        device_.offer(Device::kSlowIn, {1});
    }
    scheduler_.advance(100ms);
    EXPECT_EQ(times_ms, (std::vector<double>{11, 12, 13}));
}

TEST_F(LoopbackPace, WaitingForAQuietEndpointCostsNoTimers) {
    open();
    std::vector<double> times_ms;
    ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, stamp(times_ms)));
    ASSERT_TRUE(link_->submitIn(Device::kSlowIn, 4, stamp(times_ms)));
    scheduler_.advance(100ms);
    EXPECT_EQ(scheduler_.pending(), 0U);
    scheduler_.advance(24h);
    device_.offer(Device::kFastIn, {1});
    EXPECT_EQ(scheduler_.pending(), 1U);
    scheduler_.advance(1ms);
    EXPECT_EQ(times_ms.size(), 1U);
    EXPECT_EQ(scheduler_.pending(), 0U);
}

TEST_F(LoopbackPace, ABusyDeviceTakesThePacketInTheFrameAfterItIsReady) {
    open();
    device_.setBusy(true);
    std::vector<double> times_ms;
    ASSERT_TRUE(link_->submitOut(Device::kFastOut, {}, stamp(times_ms)));
    scheduler_.advance(5500us);
    EXPECT_TRUE(times_ms.empty());
    device_.setBusy(false);
    scheduler_.advance(10ms);
    EXPECT_EQ(times_ms, std::vector<double>{16});
}

TEST_F(LoopbackPace, OpeningTakesTwoFrames) {
    link_ = std::make_unique<LoopbackUsbLink>(scheduler_, device_);
    std::vector<double> times_ms;
    link_->open([&](const Result<UsbDeviceInfo>&) { times_ms.push_back(now_ms()); });
    scheduler_.advance(10ms);
    EXPECT_EQ(times_ms, std::vector<double>{2});
    EXPECT_EQ(device_.configurations(), (std::vector<std::uint8_t>{0, 1}));
}

TEST_F(LoopbackPace, ADestroyedLinkLeavesNothingBehind) {
    open();
    device_.setBusy(true);
    ASSERT_TRUE(link_->submitOut(Device::kFastOut, {}, {}));
    link_->control({0xC0, Device::kIgnore, 0, 0, 4}, {}, 1h, {});
    link_.reset();
    EXPECT_EQ(scheduler_.pending(), 0U);
    device_.unplug();
    device_.plug();
    EXPECT_EQ(scheduler_.pending(), 0U);
}

TEST_F(LoopbackPace, TheDeadlineOfAControlTransferIsExact) {
    open();
    std::vector<double> times_ms;
    link_->control({0xC0, Device::kIgnore, 0, 0, 4}, {}, 30ms, stamp(times_ms));
    scheduler_.advance(1s);
    EXPECT_EQ(times_ms, std::vector<double>{40});
}

}  // namespace
}  // namespace kickstand
