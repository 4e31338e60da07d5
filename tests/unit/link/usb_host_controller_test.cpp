#include "core/link/usb_host_controller.h"

#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "tests/support/usb/fake_usb_device.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;
using Device = testing::FakeUsbDevice;

/// What links do not ask for, or cannot see: the rest is tested through them.
class HostController : public ::testing::Test {
  protected:
    struct Ending {
        UsbStatus status = UsbStatus::Failed;
        Bytes data;
        std::size_t actual = 0;
        TimePoint time{};
    };

    UsbCallback record() {
        return [this](const UsbCompletion& completion) {
            endings_.push_back({completion.status,
                                {completion.data.begin(), completion.data.end()},
                                completion.actual,
                                scheduler_.now()});
        };
    }
    /// What ended, once the scheduler has had that long.
    std::vector<Ending> after(Duration span) {
        scheduler_.advance(span);
        return std::exchange(endings_, {});
    }
    static Bytes packet(std::size_t size) {
        Bytes bytes(size);
        std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
        return bytes;
    }

    FakeScheduler scheduler_;
    Device device_;
    std::unique_ptr<UsbHostController> controller_ = std::make_unique<UsbHostController>(scheduler_, device_);
    std::vector<Ending> endings_;
};

TEST_F(HostController, ALongOutTransferHoldsItsPlace) {
    controller_->out(Device::kFastOut, packet(130), false, record());
    controller_->out(Device::kFastOut, {}, false, record());
    const auto ended = after(10ms);
    ASSERT_EQ(ended.size(), 2U);
    EXPECT_EQ(ended[0].time - TimePoint(), 3ms);
    EXPECT_EQ(ended[0].actual, 130U);
    EXPECT_EQ(ended[1].time - TimePoint(), 4ms);
    ASSERT_EQ(device_.received().size(), 4U);
    EXPECT_EQ(device_.received()[2].bytes, (Bytes{128, 129}));
    EXPECT_TRUE(device_.received()[3].bytes.empty());
}

TEST_F(HostController, ACancelTellsWhatHadMoved) {
    const UsbTransferId out = controller_->out(Device::kFastOut, packet(200), false, record());
    const UsbTransferId in = controller_->in(Device::kBulkIn, 64, record());
    device_.offer(Device::kBulkIn, packet(8));
    scheduler_.advance(2ms);
    EXPECT_EQ(controller_->waiting(), 2U);
    EXPECT_TRUE(controller_->cancel(out));
    EXPECT_TRUE(controller_->cancel(in, UsbStatus::TimedOut));
    EXPECT_FALSE(controller_->cancel(in)) << "it has ended, though nobody was told yet";
    const auto ended = after(0ms);
    ASSERT_EQ(ended.size(), 2U);
    EXPECT_EQ(ended[0].status, UsbStatus::Cancelled);
    EXPECT_EQ(ended[0].actual, 128U);
    EXPECT_EQ(ended[1].status, UsbStatus::TimedOut);
    EXPECT_EQ(ended[1].data, packet(8));
    EXPECT_EQ(controller_->waiting(), 0U);
}

TEST_F(HostController, AnInTransferEndsWhenItIsFull) {
    for (int i = 0; i < 3; ++i)
        device_.offer(Device::kBulkIn, packet(8));
    controller_->in(Device::kBulkIn, 16, record());
    controller_->in(Device::kBulkIn, 12, record());
    auto ended = after(10ms);
    ASSERT_EQ(ended.size(), 1U) << "the second waits for its last four bytes";
    EXPECT_EQ(ended[0].status, UsbStatus::Completed);
    EXPECT_EQ(ended[0].actual, 16U);
    device_.offer(Device::kBulkIn, packet(8));
    ended = after(10ms);
    ASSERT_EQ(ended.size(), 1U);
    EXPECT_EQ(ended[0].status, UsbStatus::Overflow);
    EXPECT_EQ(ended[0].actual, 8U) << "what came before";
}

TEST_F(HostController, AnUnplugInTheMiddleEndsALongTransfer) {
    device_.setObserver([this] {
        if (device_.received().size() == 2 && device_.attached()) device_.unplug();
    });
    controller_->out(Device::kFastOut, packet(200), false, record());
    controller_->in(Device::kFastIn, 64, record());
    const auto ended = after(1s);
    ASSERT_EQ(ended.size(), 2U);
    for (const Ending& one : ended)
        EXPECT_EQ(one.status, UsbStatus::NoDevice);
    EXPECT_EQ(scheduler_.pending(), 0U);
}

TEST_F(HostController, AReplugFromInsideACallDoesNotCarryATransferOver) {
    bool replugged = false;
    device_.setObserver([&] {
        if (std::exchange(replugged, true)) return;
        device_.unplug();
        device_.plug();
    });
    controller_->out(Device::kFastOut, packet(200), false, record());
    const auto ended = after(1s);
    ASSERT_EQ(ended.size(), 1U);
    EXPECT_EQ(ended[0].status, UsbStatus::NoDevice);
    EXPECT_EQ(device_.received().size(), 1U);
}

TEST_F(HostController, NothingMovesWhileUnplugged) {
    device_.unplug();
    controller_->control({0x80, 6, 0x0100, 0, 18}, {}, record());
    controller_->out(Device::kFastOut, {}, false, record());
    controller_->in(Device::kFastIn, 64, record());
    EXPECT_TRUE(endings_.empty()) << "called back from inside the call";
    for (const Ending& one : after(0ms))
        EXPECT_EQ(one.status, UsbStatus::NoDevice);
    device_.plug();
    controller_->in(Device::kFastIn, 64, record());
    device_.offer(Device::kFastIn, {1});
    const auto ended = after(1ms);
    ASSERT_EQ(ended.size(), 1U);
    EXPECT_EQ(ended[0].data, Bytes{1});
}

TEST_F(HostController, AnEndpointThatIsNotThereFails) {
    controller_->out(0x0A, {}, false, record());
    controller_->out(Device::kFastIn, {}, false, record());
    controller_->in(0x8A, 8, record());
    controller_->in(Device::kFastOut, 8, record());
    const auto ended = after(0ms);
    ASSERT_EQ(ended.size(), 4U);
    for (const Ending& one : ended)
        EXPECT_EQ(one.status, UsbStatus::Failed);
}

TEST_F(HostController, AttachmentIsToldAtOnceAndLaterComesAfterTheEndings) {
    std::vector<std::string> heard;
    controller_->setAttachedListener([&](bool attached) {
        heard.emplace_back(attached ? "plugged" : "unplugged");
        controller_->later([&] { heard.emplace_back("later"); });
    });
    controller_->in(Device::kFastIn, 64, [&](const UsbCompletion&) { heard.emplace_back("ended"); });
    device_.unplug();
    EXPECT_EQ(heard, std::vector<std::string>{"unplugged"});
    scheduler_.runPending();
    EXPECT_EQ(heard, (std::vector<std::string>{"unplugged", "ended", "later"}));
}

TEST_F(HostController, DestroyedFromACallbackItIsSilent) {
    controller_->out(Device::kFastOut, {}, false, [this](const UsbCompletion&) { controller_.reset(); });
    controller_->in(Device::kFastIn, 64, record());
    controller_->later([] {});
    EXPECT_TRUE(after(1s).empty());
    EXPECT_EQ(scheduler_.pending(), 0U);
    device_.offer(Device::kFastIn, {1});
    EXPECT_EQ(scheduler_.pending(), 0U);
}

}  // namespace
}  // namespace kickstand
