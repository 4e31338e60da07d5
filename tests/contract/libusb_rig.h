#pragma once

#include "core/base/thread_scheduler.h"
#include "core/link/usb/libusb_link.h"
#include "tests/contract/usb_rig.h"
#include "tests/support/usb/umockdev_bus.h"

namespace kickstand::testing {

/// A real scheduler that asks a question after each of its calls, which is what makes waiting for an answer
/// an event.
class WatchedScheduler final : public Scheduler {
  public:
    TimePoint now() const override { return inner_.now(); }
    TimerId callAt(TimePoint when, Callback callback) override;
    void post(Callback callback) override;
    bool cancel(TimerId id) override { return inner_.cancel(id); }

    /// Does something on the scheduler's thread and waits for its end. Not from there.
    void run(const std::function<void()>& action);
    /// Waits until `done`, asked on the scheduler's thread, holds. False when a watchdog had to end the wait.
    /// Not from there.
    bool waitUntil(const std::function<bool()>& done);

  private:
    Callback watched(Callback callback);

    std::function<bool()> question_;
    ThreadScheduler inner_;
};

/// A device on an emulated bus and unmodified libusb, each on the thread of its own real scheduler.
class LibusbRig : public UsbRig {
  public:
    explicit LibusbRig(UsbWatchOptions options = {});
    ~LibusbRig() override;

    /// What finds the device; without a port.
    static UsbMatch match();

    std::unique_ptr<UsbLink> makeLink() override { return makeLink(match()); }
    std::unique_ptr<UsbLink> makeLink(UsbMatch match);
    Scheduler& scheduler() override { return linkThread_; }
    void onLink(const std::function<void()>& action) override { linkThread_.run(action); }
    void onDevice(const std::function<void(FakeUsbDevice&)>& action) override;
    bool waitUntil(const std::function<bool()>& done) override { return linkThread_.waitUntil(done); }
    void settle() override;

    UmockdevBus& bus() { return *bus_; }

  private:
    const UsbWatchOptions options_;
    WatchedScheduler deviceThread_;
    WatchedScheduler linkThread_;
    FakeUsbDevice device_;
    std::unique_ptr<UmockdevBus> bus_;
};

}  // namespace kickstand::testing
