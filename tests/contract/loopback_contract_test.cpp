#include "core/base/fake_scheduler.h"
#include "core/link/loopback/loopback_usb_link.h"
#include "core/link/tapped_usb_link.h"
#include "tests/contract/usb_link_contract.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;

/// Everything on the test's own thread, in the time of a fake scheduler.
class LoopbackRig : public UsbRig {
  public:
    std::unique_ptr<UsbLink> makeLink() override {
        return std::make_unique<LoopbackUsbLink>(scheduler_, device_, LoopbackOptions{.port = "1-1"});
    }
    Scheduler& scheduler() override { return scheduler_; }
    void onLink(const std::function<void()>& action) override { action(); }
    void onDevice(const std::function<void(FakeUsbDevice&)>& action) override { action(device_); }
    bool waitUntil(const std::function<bool()>& done) override { return scheduler_.runUntil(done, 60s); }
    void settle() override { scheduler_.advance(1s); }

  private:
    FakeScheduler scheduler_;
    FakeUsbDevice device_;
};

class TappedRig final : public LoopbackRig {
  public:
    std::unique_ptr<UsbLink> makeLink() override {
        return std::make_unique<TappedUsbLink>(LoopbackRig::makeLink(), scheduler());
    }
};

/// Link and device on the thread of a real scheduler, as the engine runs them.
class ThreadedRig final : public UsbRig {
  public:
    std::unique_ptr<UsbLink> makeLink() override {
        return std::make_unique<TappedUsbLink>(
            std::make_unique<LoopbackUsbLink>(scheduler_, device_, LoopbackOptions{.port = "1-1"}),
            scheduler_);
    }
    Scheduler& scheduler() override { return scheduler_; }
    void onLink(const std::function<void()>& action) override { scheduler_.run(action); }
    void onDevice(const std::function<void(FakeUsbDevice&)>& action) override {
        scheduler_.run([&] { action(device_); });
    }
    bool waitUntil(const std::function<bool()>& done) override { return scheduler_.waitUntil(done); }
    void settle() override {
        scheduler_.run([] {});
    }

  private:
    FakeUsbDevice device_;
    WatchedScheduler scheduler_;
};

INSTANTIATE_TEST_SUITE_P(
    Loopback, UsbLinkContract,
    ::testing::Values(UsbRigFactory{"loopback", [] { return std::make_unique<LoopbackRig>(); }},
                      UsbRigFactory{"tapped loopback", [] { return std::make_unique<TappedRig>(); }},
                      UsbRigFactory{"tapped loopback on a thread",
                                    [] { return std::make_unique<ThreadedRig>(); }}));

}  // namespace
}  // namespace kickstand::testing
