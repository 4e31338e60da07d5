#include "core/link/usb/libusb_device.h"

#include <algorithm>

namespace kickstand::usb {
namespace {

/// libusb's word for configuration 0.
constexpr int kUnconfigured = -1;
constexpr int kConfiguration = 1;
/// The part of wMaxPacketSize that is the size (USB 2.0, table 9-13).
constexpr std::uint16_t kPacketSizeMask = 0x07FF;
constexpr std::uint8_t kTypeMask = 0x03;

struct ConfigFree {
    void operator()(libusb_config_descriptor* config) const { libusb_free_config_descriptor(config); }
};

UsbEndpointInfo toInfo(const libusb_endpoint_descriptor& descriptor, std::uint8_t interface) {
    UsbEndpointInfo info;
    info.address = descriptor.bEndpointAddress;
    info.type = static_cast<UsbEndpointInfo::Type>(descriptor.bmAttributes & kTypeMask);
    info.packetSize = descriptor.wMaxPacketSize & kPacketSizeMask;
    info.interval_ms = descriptor.bInterval;
    info.interface = interface;
    return info;
}

Result<DeviceRef> findOne(libusb_context* context, const UsbMatch& match) {
    auto found = findDevices(context, match);
    if (!found) return fail(std::move(found.error()));
    if (found->empty()) return fail(Errc::NoDevice, match.port.value_or("usb"));
    if (found->size() == 1) return std::move(found->front());
    std::string ports;
    for (const DeviceRef& device : *found)
        ports += (ports.empty() ? "" : ", ") + portOf(device.get());
    return fail(Errc::SeveralDevices, "usb", std::move(ports));
}

}  // namespace

Result<std::unique_ptr<LibusbDevice>> LibusbDevice::open(libusb_context* context, const UsbMatch& match,
                                                         std::function<void(EndedTransfer)> ended) {
    auto found = findOne(context, match);
    if (!found) return fail(std::move(found.error()));
    libusb_device_handle* handle = nullptr;
    if (const int result = libusb_open(found->get(), &handle); result != LIBUSB_SUCCESS)
        return failWith(result, portOf(found->get()));
    std::unique_ptr<LibusbDevice> device(
        new LibusbDevice(std::move(*found), Handle(handle), std::move(ended)));
    if (auto configured = device->configure(match.interfaces); !configured)
        return fail(std::move(configured.error()));
    return device;
}

LibusbDevice::LibusbDevice(DeviceRef device, Handle handle, std::function<void(EndedTransfer)> ended)
    : device_(std::move(device)), handle_(std::move(handle)), transfers_(std::move(ended)) {}

LibusbDevice::~LibusbDevice() {
    // In this order: libusb reports a waiting IN transfer as completed when its interface is released under
    // it, and must have let go of every transfer before the device is closed.
    transfers_.cancelAllAndWait();
    for (const std::uint8_t interface : claimed_)
        libusb_release_interface(handle_.get(), interface);
}

Result<void> LibusbDevice::configure(const std::vector<std::uint8_t>& interfaces) {
    const std::string port = portOf(device_.get());
    for (const int configuration : {kUnconfigured, kConfiguration}) {
        if (const int result = libusb_set_configuration(handle_.get(), configuration);
            result != LIBUSB_SUCCESS)
            return failWith(result, port);
    }
    for (const std::uint8_t interface : interfaces) {
        if (const int result = libusb_claim_interface(handle_.get(), interface); result != LIBUSB_SUCCESS)
            return failWith(result, port);
        claimed_.push_back(interface);
    }
    info_ = describe(device_.get(), handle_.get());
    return readEndpoints();
}

Result<void> LibusbDevice::readEndpoints() {
    libusb_config_descriptor* read = nullptr;
    if (const int result = libusb_get_active_config_descriptor(device_.get(), &read);
        result != LIBUSB_SUCCESS)
        return failWith(result, info_.port);
    const std::unique_ptr<libusb_config_descriptor, ConfigFree> config(read);
    for (int i = 0; i < config->bNumInterfaces; ++i) {
        const libusb_interface& interface = config->interface[i];
        if (interface.num_altsetting < 1) continue;
        const libusb_interface_descriptor& setting = interface.altsetting[0];
        if (std::find(claimed_.begin(), claimed_.end(), setting.bInterfaceNumber) == claimed_.end()) continue;
        for (int e = 0; e < setting.bNumEndpoints; ++e)
            endpoints_.push_back(toInfo(setting.endpoint[e], setting.bInterfaceNumber));
    }
    return {};
}

int LibusbDevice::submit(TransferRequest request) {
    const auto found = std::find_if(endpoints_.begin(), endpoints_.end(), [&](const UsbEndpointInfo& info) {
        return info.address == request.endpoint;
    });
    if (!request.setup && found == endpoints_.end()) return LIBUSB_ERROR_NOT_FOUND;
    if (!request.setup) request.type = static_cast<unsigned char>(found->type);
    return transfers_.submit(handle_.get(), request);
}

UsbStatus LibusbDevice::clearHalt(std::uint8_t endpoint) {
    switch (libusb_clear_halt(handle_.get(), endpoint)) {
        case LIBUSB_SUCCESS:
            return UsbStatus::Completed;
        case LIBUSB_ERROR_NO_DEVICE:
            return UsbStatus::NoDevice;
        case LIBUSB_ERROR_PIPE:
            return UsbStatus::Stalled;
        default:
            return UsbStatus::Failed;
    }
}

}  // namespace kickstand::usb
