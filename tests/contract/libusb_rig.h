#pragma once

#include "core/link/usb/libusb_link.h"
#include "tests/contract/usb_rig.h"
#include "tests/support/usb/umockdev_bus.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::testing {

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
    /// Keeps libusb listening from the first plug to the last, whatever links come and go.
    std::unique_ptr<UsbLink> listening_;
};

}  // namespace kickstand::testing
