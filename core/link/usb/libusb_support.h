#pragma once

#include <memory>
#include <vector>

#include <libusb.h>

#include "core/base/result.h"
#include "core/link/usb_types.h"

namespace kickstand::usb {

/// A libusb error code as an Error: Disconnected, PermissionDenied, ClaimedElsewhere or Io, with libusb's own
/// word as the detail.
Error toError(int code, std::string subject);
tl::unexpected<Error> failWith(int code, std::string subject);

/// Gives libusb's record of a device back.
struct DeviceUnref {
    void operator()(libusb_device* device) const { libusb_unref_device(device); }
};
/// A counted reference to a device on the bus, opened or not.
using DeviceRef = std::unique_ptr<libusb_device, DeviceUnref>;

/// Closes an open device.
struct HandleClose {
    void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using Handle = std::unique_ptr<libusb_device_handle, HandleClose>;

/// A device's place on the bus: "1-2.3".
std::string portOf(libusb_device* device);
/// Whether vendor, product and, where one is given, the port are those of `match`.
bool matches(libusb_device* device, const UsbMatch& match);
/// All devices that match, ordered by port. Errors: Io.
Result<std::vector<DeviceRef>> findDevices(libusb_context* context, const UsbMatch& match);
/// What the descriptors say. Strings need an open device: without a `handle` they stay empty.
UsbDeviceInfo describe(libusb_device* device, libusb_device_handle* handle);

}  // namespace kickstand::usb
