#include "core/link/usb/usb_probe.h"

#include "core/link/usb/libusb_support.h"

namespace kickstand {
namespace {

struct ContextExit {
    void operator()(libusb_context* context) const { libusb_exit(context); }
};

bool isHeldElsewhere(libusb_device_handle* handle, const UsbMatch& match) {
    for (const std::uint8_t interface : match.interfaces) {
        const int result = libusb_claim_interface(handle, interface);
        if (result == LIBUSB_ERROR_BUSY) return true;
        if (result == LIBUSB_SUCCESS) libusb_release_interface(handle, interface);
    }
    return false;
}

UsbProbe probe(libusb_device* device, const UsbMatch& match) {
    UsbProbe result;
    libusb_device_handle* opened = nullptr;
    result.permitted = libusb_open(device, &opened) != LIBUSB_ERROR_ACCESS;
    const usb::Handle handle(opened);
    result.info = usb::describe(device, opened);
    result.claimedElsewhere = opened != nullptr && isHeldElsewhere(opened, match);
    return result;
}

}  // namespace

Result<std::vector<UsbProbe>> probeUsbDevices(const UsbMatch& match) {
    libusb_context* made = nullptr;
    if (const int result = libusb_init(&made); result != LIBUSB_SUCCESS)
        return usb::failWith(result, "libusb");
    const std::unique_ptr<libusb_context, ContextExit> context(made);
    auto found = usb::findDevices(made, match);
    if (!found) return fail(std::move(found.error()));
    std::vector<UsbProbe> probes;
    for (const usb::DeviceRef& device : *found)
        probes.push_back(probe(device.get(), match));
    // References to devices end before the context does.
    found->clear();
    return probes;
}

Result<std::vector<UsbDeviceInfo>> listUsbDevices(const UsbMatch& match) {
    UsbMatch noInterfaces = match;
    noInterfaces.interfaces.clear();
    const auto probes = probeUsbDevices(noInterfaces);
    if (!probes) return fail(probes.error());
    std::vector<UsbDeviceInfo> devices;
    for (const UsbProbe& found : *probes)
        devices.push_back(found.info);
    return devices;
}

}  // namespace kickstand
