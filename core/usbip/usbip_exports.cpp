#include "core/usbip/usbip_exports.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

namespace kickstand {
namespace {

// Places in the device descriptor (USB 2.0, table 9-8).
constexpr std::size_t kDeviceDescriptorSize = 18;
constexpr std::size_t kClassAt = 4;
constexpr std::size_t kVendorAt = 8;
constexpr std::size_t kProductAt = 10;
constexpr std::size_t kReleaseAt = 12;
constexpr std::size_t kConfigurationsAt = 17;

// And in an interface descriptor (table 9-12).
constexpr std::uint8_t kInterfaceDescriptor = 4;
constexpr std::size_t kInterfaceDescriptorSize = 9;
constexpr std::size_t kAlternateAt = 3;
constexpr std::size_t kInterfaceClassAt = 5;

/// The first number on a bus belongs to its root hub.
constexpr std::uint32_t kFirstDevice = 2;

std::vector<usbip::InterfaceClass> interfacesOf(ByteView configuration) {
    std::vector<usbip::InterfaceClass> interfaces;
    while (configuration.size() >= 2 && configuration[0] >= 2 && configuration[0] <= configuration.size()) {
        const ByteView descriptor = configuration.first(configuration[0]);
        configuration = configuration.subspan(descriptor.size());
        const bool counts = descriptor[1] == kInterfaceDescriptor &&
                            descriptor.size() >= kInterfaceDescriptorSize && descriptor[kAlternateAt] == 0;
        if (!counts || interfaces.size() == usbip::kMaxInterfaces) continue;
        interfaces.push_back({descriptor[kInterfaceClassAt], descriptor[kInterfaceClassAt + 1],
                              descriptor[kInterfaceClassAt + 2]});
    }
    return interfaces;
}

/// The bus that a bus id begins with; 1 where it does not say.
std::uint32_t busOf(const std::string& busId) {
    std::uint16_t bus = 0;
    std::from_chars(busId.data(), busId.data() + busId.size(), bus);
    return bus == 0 ? 1 : bus;
}

usbip::Device describe(const UsbipExport& exported, std::size_t index) {
    const UsbDescriptors& descriptors = exported.model->descriptors();
    usbip::Device device;
    device.busId = exported.busId;
    device.bus = busOf(exported.busId);
    device.number = static_cast<std::uint32_t>(kFirstDevice + index);
    device.path = "/sys/devices/kickstand/usb" + std::to_string(device.bus) + "/" + exported.busId;
    device.interfaces = interfacesOf(descriptors.configuration);
    const ByteView bytes = descriptors.device;
    if (bytes.size() < kDeviceDescriptorSize) return device;
    device.vendor = loadLe16(bytes, kVendorAt);
    device.product = loadLe16(bytes, kProductAt);
    device.release = loadLe16(bytes, kReleaseAt);
    device.deviceClass = {bytes[kClassAt], bytes[kClassAt + 1], bytes[kClassAt + 2]};
    device.configurations = bytes[kConfigurationsAt];
    return device;
}

/// Whether a bus id travels unchanged and can be typed by a person.
bool canTravel(const std::string& busId) {
    const auto printable = [](char c) { return c > ' ' && c <= '~' && c != '/'; };
    return !busId.empty() && busId.size() <= usbip::kMaxBusIdLength && std::ranges::all_of(busId, printable);
}

}  // namespace

Result<UsbipExports> UsbipExports::make(std::span<const UsbipExport> exports) {
    if (exports.size() > usbip::kMaxDevices) return fail(Errc::OutOfRange, "exported devices");
    UsbipExports made;
    made.entries_.reserve(exports.size());
    for (const UsbipExport& exported : exports) {
        if (!exported.model) return fail(Errc::BadArgument, "bus id", exported.busId + " has no device");
        if (!canTravel(exported.busId)) return fail(Errc::BadArgument, "bus id", exported.busId);
        if (made.find(exported.busId)) return fail(Errc::BadArgument, "bus id", exported.busId + " twice");
        made.entries_.push_back({describe(exported, made.entries_.size()), exported.model, false});
    }
    return made;
}

std::vector<usbip::Device> UsbipExports::present() const {
    std::vector<usbip::Device> devices;
    for (const Entry& entry : entries_) {
        if (entry.model->attached()) devices.push_back(entry.device);
    }
    return devices;
}

UsbipExports::Entry* UsbipExports::find(const std::string& busId) {
    const auto found =
        std::ranges::find(entries_, busId, [](const Entry& entry) { return entry.device.busId; });
    return found == entries_.end() ? nullptr : &*found;
}

bool UsbipExports::anyTaken() const {
    return std::ranges::any_of(entries_, &Entry::taken);
}

}  // namespace kickstand
