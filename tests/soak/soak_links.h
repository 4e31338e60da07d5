#pragma once

#include <list>
#include <memory>
#include <optional>

#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"
#include "core/link/usb_link.h"
#include "core/usbip/usbip_connection.h"

namespace kickstand::soak {

/// Links to a simulated dongle: loopbacks, or clients of a USB/IP server that are connected with it in
/// memory. On the scheduler's thread.
class SoakLinks {
  public:
    SoakLinks(bool overUsbip, std::uint32_t seed) : overUsbip_(overUsbip), seed_(seed) {}

    /// `device` must stay until cut() has been called for the last time.
    std::unique_ptr<UsbLink> make(UsbDeviceModel& device, Scheduler& scheduler);
    /// Ends every connection to the server, and takes none any more.
    void cut();
    /// Takes connections again.
    void mend() { reachable_ = true; }

  private:
    std::unique_ptr<ByteStream> connect(Scheduler& scheduler);

    const bool overUsbip_;
    std::uint32_t seed_;
    bool reachable_ = true;
    std::optional<UsbipHall> hall_;
    std::list<std::unique_ptr<UsbipConnection>> connections_;
};

}  // namespace kickstand::soak
