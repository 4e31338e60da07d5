#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/link/usb_device_model.h"
#include "core/link/usbip/usbip_wire.h"

namespace kickstand {

/// A device under the name that clients ask for.
struct UsbipExport {
    std::string busId;  ///< "1-1".
    UsbDeviceModel* model = nullptr;
};

/// The devices of a server, as clients are told of them, and which of them are taken. On the thread of the
/// models, which must outlive it.
class UsbipExports {
  public:
    /// One exported device.
    struct Entry {
        usbip::Device device;
        UsbDeviceModel* model = nullptr;
        bool taken = false;  ///< Somebody has imported it.
    };

    /// Errors: BadArgument for a bus id that cannot travel, is there twice or has no device.
    static Result<UsbipExports> make(std::span<const UsbipExport> exports);

    /// Those that are plugged in, taken or not.
    std::vector<usbip::Device> present() const;
    /// The entry of that name, plugged in or not; null where there is none. It stays where it is.
    Entry* find(const std::string& busId);
    /// Whether somebody has imported one.
    bool anyTaken() const;

  private:
    std::vector<Entry> entries_;
};

}  // namespace kickstand
