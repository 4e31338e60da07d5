#pragma once

#include <memory>

#include "core/base/scheduler.h"
#include "core/link/usb_link.h"

namespace kickstand {

/// How a link learns that devices come and go.
struct UsbWatchOptions {
    /// Looks at the list of devices now and then, even where the system would tell. Where it cannot tell,
    /// this happens anyway.
    bool poll = false;
    Duration pollInterval = std::chrono::seconds(1);
};

/// A link to a real USB device through libusb. It has two threads of its own, one that waits for libusb's
/// events and one for what may block; from its making on it watches for the device. Its deadlines are the
/// scheduler's: no transfer has one in libusb. It detaches no kernel driver: a device that one has claimed is
/// ClaimedElsewhere.
///
/// Destroying it waits for what is under way, as a set-configuration to a device that does not answer; close
/// it first where that matters. `scheduler` must outlive it.
std::unique_ptr<UsbLink> makeLibusbLink(Scheduler& scheduler, UsbMatch match, UsbWatchOptions options = {});

}  // namespace kickstand
