#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/link/usb_types.h"

namespace kickstand {

/// A device that is there, and what stands in the way of using it.
struct UsbProbe {
    UsbDeviceInfo info;             ///< Its strings are empty where it may not be opened.
    bool permitted = false;         ///< This user may open it.
    bool claimedElsewhere = false;  ///< Another program or a kernel driver holds one of the interfaces.

    friend bool operator==(const UsbProbe&, const UsbProbe&) = default;
};

/// Every device that matches, by its place on the bus; empty when there is none. Asks for the interfaces of
/// `match` for a moment and gives them back; a device in use notices nothing. Blocks, so not on the engine's
/// thread; any other. Errors: Io when USB cannot be reached at all.
Result<std::vector<UsbProbe>> probeUsbDevices(const UsbMatch& match);

/// The same devices without asking for their interfaces. Blocks. Errors as probeUsbDevices().
Result<std::vector<UsbDeviceInfo>> listUsbDevices(const UsbMatch& match);

}  // namespace kickstand
