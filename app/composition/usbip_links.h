#pragma once

#include <memory>

#include "core/base/scheduler.h"
#include "core/link/link_uri.h"
#include "core/link/usb_link.h"

namespace kickstand {

/// Whether this is a device on a USB/IP server (`usbip:HOST[:PORT]/BUSID`).
bool isUsbip(const LinkUri& uri);

/// Errors: BadUri for a target of another form, or for any option.
Result<void> checkUsbipLink(const LinkUri& uri);

/// A link to it, whether it is a dongle or a robot on the direct cable. Errors as checkUsbipLink().
Result<std::unique_ptr<UsbLink>> makeUsbipLink(const LinkUri& uri, Scheduler& scheduler);

}  // namespace kickstand
