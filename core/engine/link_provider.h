#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/byte_link.h"
#include "core/link/byte_ports.h"
#include "core/link/link_uri.h"
#include "core/link/sim_control.h"
#include "core/link/usb_link.h"

namespace kickstand {

/// A program that holds a device open.
struct DeviceHolder {
    int pid = 0;
    std::string name;

    friend bool operator==(const DeviceHolder&, const DeviceHolder&) = default;
};

/// A device that could be connected to, found without disturbing it.
struct FoundDevice {
    LinkUri uri;
    UsbDeviceInfo info;
    /// PermissionDenied or ClaimedElsewhere, where it could not be opened now.
    std::optional<Error> obstacle{};
    /// For ClaimedElsewhere: who, as far as the system tells this user.
    std::optional<DeviceHolder> holder{};
    /// The udev rule that is to let people open it, by its path; empty where there is none.
    std::string rule{};
};

/// What hardware there is.
struct FoundHardware {
    std::vector<FoundDevice> devices;  ///< What is known to be one of ours.
    std::vector<BytePort> ports;       ///< Serial ports, at which anything may be; by their names.
};

/// A link ready to be opened, with what it stands on.
struct ProvidedUsbLink {
    std::shared_ptr<void> keepAlive;  ///< A simulated device; destroyed after the link.
    std::unique_ptr<UsbLink> link;
    SimControl* sim = nullptr;  ///< Null for hardware.
};

/// A serial line ready to be opened, with what it stands on.
struct ProvidedByteLink {
    std::shared_ptr<void> keepAlive;  ///< A simulated device; destroyed after the link.
    std::unique_ptr<ByteLink> link;
    SimControl* sim = nullptr;  ///< Null for hardware.
};

/// The serial ports that a system with a device on each is to look at, with what they stand on.
struct ProvidedBytePorts {
    std::shared_ptr<void> keepAlive;  ///< Simulated devices; destroyed after the ports and their links.
    std::unique_ptr<BytePorts> ports;
    SimControl* sim = nullptr;    ///< Null for hardware.
    std::string catalogue;        ///< The text of the user's catalogue of boards; empty for none.
    std::string catalogueSource;  ///< Where it was read from.
};

/// Turns URIs into links. Implemented by the composition of a program, the only place that knows which links
/// and simulators were built in; by test doubles elsewhere. Called on the engine thread; must not block.
class LinkProvider {
  public:
    virtual ~LinkProvider() = default;
    /// Errors: BadUri for a scheme or option it does not take, Unsupported for a system it does not know.
    virtual Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) = 0;
    /// One serial line: `serial:PATH?protocol=coach&baud=9600`, `sim:coach`. Errors as makeUsbLink(). A
    /// provider without serial lines gives Unsupported.
    virtual Result<ProvidedByteLink> makeByteLink(const LinkUri& uri, Scheduler& scheduler);
    /// The serial ports for smart devices: `serial:` for all that are on USB, `serial:PATH` for one,
    /// `sim:smartdevice` for simulated ones. Errors as makeByteLink().
    virtual Result<ProvidedBytePorts> makeBytePorts(const LinkUri& uri, Scheduler& scheduler);
    /// Looks for hardware on a thread of its own and posts what there is to the scheduler.
    virtual void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) = 0;
};

}  // namespace kickstand
