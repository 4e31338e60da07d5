#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "core/base/scheduler.h"
#include "core/link/usb_link.h"
#include "tests/support/usb/fake_usb_device.h"

namespace kickstand::testing {

/// What the contract of USB links is checked on: a device, a way to make links to it, and a way to wait. The
/// suite knows nothing else of the link that it checks.
class UsbRig {
  public:
    virtual ~UsbRig() = default;

    virtual std::unique_ptr<UsbLink> makeLink() = 0;
    /// The device's place as links tell it.
    virtual std::string port() const { return "1-1"; }
    /// The scheduler that links are made with.
    virtual Scheduler& scheduler() = 0;
    /// Does something on the links' thread and waits for its end.
    virtual void onLink(const std::function<void()>& action) = 0;
    /// Does something on the device's thread and waits for its end.
    virtual void onDevice(const std::function<void(FakeUsbDevice&)>& action) = 0;
    /// Waits until `done`, which is asked on the links' thread, holds. False when a watchdog had to end the
    /// wait.
    virtual bool waitUntil(const std::function<bool()>& done) = 0;
    /// Waits until all that is under way has ended, so that what has not come by then does not come any more.
    virtual void settle() = 0;
};

/// Makes a fresh rig for each test.
struct UsbRigFactory {
    const char* link = "";
    std::function<std::unique_ptr<UsbRig>()> make;

    friend void PrintTo(const UsbRigFactory& factory, std::ostream* out) { *out << factory.link; }
};

}  // namespace kickstand::testing
