#include "core/link/usb/libusb_support.h"

#include <algorithm>
#include <array>

namespace kickstand::usb {
namespace {

/// USB allows five hubs in a row, so that no place has more parts (USB 2.0, 4.1.1).
constexpr int kDeepestPort = 7;
constexpr std::size_t kLongestString = 256;

Errc codeOf(int code) {
    switch (code) {
        case LIBUSB_ERROR_NO_DEVICE:
            return Errc::Disconnected;
        case LIBUSB_ERROR_ACCESS:
            return Errc::PermissionDenied;
        case LIBUSB_ERROR_BUSY:
            return Errc::ClaimedElsewhere;
        default:
            return Errc::Io;
    }
}

std::string readString(libusb_device_handle* handle, std::uint8_t index) {
    if (handle == nullptr || index == 0) return {};
    std::array<unsigned char, kLongestString> text{};
    const int size =
        libusb_get_string_descriptor_ascii(handle, index, text.data(), static_cast<int>(text.size()));
    return size > 0 ? std::string(text.begin(), text.begin() + size) : std::string();
}

}  // namespace

Error toError(int code, std::string subject) {
    Error error;
    error.code = codeOf(code);
    error.subject = std::move(subject);
    error.detail = libusb_error_name(code);
    return error;
}

tl::unexpected<Error> failWith(int code, std::string subject) {
    return fail(toError(code, std::move(subject)));
}

std::string portOf(libusb_device* device) {
    std::array<std::uint8_t, kDeepestPort> ports{};
    const int depth = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
    std::string place = std::to_string(libusb_get_bus_number(device));
    char separator = '-';
    for (int i = 0; i < depth; ++i) {
        place += separator;
        place += std::to_string(ports.at(static_cast<std::size_t>(i)));
        separator = '.';
    }
    return place;
}

bool matches(libusb_device* device, const UsbMatch& match) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(device, &descriptor) != LIBUSB_SUCCESS) return false;
    return match.takes(descriptor.idVendor, descriptor.idProduct) &&
           (!match.port || *match.port == portOf(device));
}

Result<std::vector<DeviceRef>> findDevices(libusb_context* context, const UsbMatch& match) {
    libusb_device** list = nullptr;
    const ssize_t count = libusb_get_device_list(context, &list);
    if (count < 0) return failWith(static_cast<int>(count), "device list");
    std::vector<DeviceRef> found;
    for (ssize_t i = 0; i < count; ++i) {
        if (matches(list[i], match)) found.emplace_back(libusb_ref_device(list[i]));
    }
    libusb_free_device_list(list, 1);
    std::sort(found.begin(), found.end(),
              [](const DeviceRef& a, const DeviceRef& b) { return portOf(a.get()) < portOf(b.get()); });
    return found;
}

UsbDeviceInfo describe(libusb_device* device, libusb_device_handle* handle) {
    UsbDeviceInfo info;
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(device, &descriptor) != LIBUSB_SUCCESS) return info;
    info.vendor = descriptor.idVendor;
    info.product = descriptor.idProduct;
    info.release = descriptor.bcdDevice;
    info.port = portOf(device);
    info.manufacturer = readString(handle, descriptor.iManufacturer);
    info.productName = readString(handle, descriptor.iProduct);
    return info;
}

}  // namespace kickstand::usb
