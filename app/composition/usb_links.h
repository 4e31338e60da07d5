#pragma once

#include <memory>
#include <vector>

#include "core/engine/link_provider.h"

namespace kickstand {

/// Whether this is a link to hardware on USB: the dongle (`usb:`) or a robot on the direct cable
/// (`usb-cable:`).
bool isHardware(const LinkUri& uri);

/// Errors: BadUri for a target, or for an option other than `port`.
Result<void> checkHardwareLink(const LinkUri& uri);

/// A link to that hardware, by its place on the bus where `port` is given. Errors as checkHardwareLink().
Result<std::unique_ptr<UsbLink>> makeHardwareLink(const LinkUri& uri, Scheduler& scheduler);

/// Every dongle and cabled robot that is plugged in, with what stands in its way. Where several are of a
/// kind, their URIs name the port. Blocks. A bus that cannot be read has no devices.
std::vector<FoundDevice> findHardware();

}  // namespace kickstand
