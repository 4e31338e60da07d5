#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/link_uri.h"
#include "core/link/sim_control.h"
#include "core/link/usb_link.h"

namespace kickstand {

/// A device that could be connected to, found without disturbing it.
struct FoundDevice {
    LinkUri uri;
    UsbDeviceInfo info;
    std::optional<Error>
        obstacle;  ///< PermissionDenied or ClaimedElsewhere, where it could not be opened now.
};

/// A link ready to be opened, with what it stands on.
struct ProvidedUsbLink {
    std::shared_ptr<void> keepAlive;  ///< A simulated device; destroyed after the link.
    std::unique_ptr<UsbLink> link;
    SimControl* sim = nullptr;  ///< Null for hardware.
};

/// Turns URIs into links. Implemented by the composition of a program, the only place that knows which links
/// and simulators were built in; by test doubles elsewhere. Called on the engine thread; must not block.
class LinkProvider {
  public:
    virtual ~LinkProvider() = default;
    /// Errors: BadUri for a scheme or option it does not take, Unsupported for a system it does not know.
    virtual Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) = 0;
    /// Looks for hardware on a thread of its own and posts what there is to the scheduler.
    virtual void discover(Scheduler& scheduler, std::function<void(std::vector<FoundDevice>)> found) = 0;
};

}  // namespace kickstand
