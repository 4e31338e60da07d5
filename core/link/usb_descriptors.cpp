#include "core/link/usb_descriptors.h"

namespace kickstand {
namespace {

constexpr std::uint8_t kDeviceType = 1;
constexpr std::uint8_t kConfigurationType = 2;
constexpr std::uint8_t kInterfaceType = 4;
constexpr std::uint8_t kEndpointType = 5;
constexpr std::uint16_t kUsb20 = 0x0200;
constexpr std::uint8_t kConfigurationValue = 1;
constexpr std::uint8_t kBusPowered = 0x80;
constexpr std::uint16_t kPowerUnit_mA = 2;

void append16(std::vector<std::uint8_t>& bytes, std::size_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

/// Gives `text` the next index; 0 stands for no string.
std::uint8_t addString(UsbDescriptors& descriptors, const std::string& text) {
    if (text.empty()) return 0;
    const auto index = static_cast<std::uint8_t>(descriptors.strings.size() + 1);
    descriptors.strings.emplace(index, text);
    return index;
}

void appendDevice(UsbDescriptors& descriptors, const UsbDeviceDescription& description) {
    auto& bytes = descriptors.device;
    bytes = {18, kDeviceType};
    append16(bytes, kUsb20);
    bytes.insert(bytes.end(), {0, 0, 0, description.controlPacketSize});
    append16(bytes, description.vendor);
    append16(bytes, description.product);
    append16(bytes, description.release);
    bytes.push_back(addString(descriptors, description.manufacturer));
    bytes.push_back(addString(descriptors, description.productName));
    bytes.push_back(addString(descriptors, description.serialNumber));
    bytes.push_back(1);
}

void appendInterface(UsbDescriptors& descriptors, std::uint8_t number,
                     const UsbInterfaceDescription& interface) {
    auto& bytes = descriptors.configuration;
    const auto endpoints = static_cast<std::uint8_t>(interface.endpoints.size());
    const std::uint8_t name = addString(descriptors, interface.name);
    bytes.insert(bytes.end(),
                 {9, kInterfaceType, number, 0, endpoints, interface.interfaceClass, 0, 0, name});
    for (UsbEndpointInfo endpoint : interface.endpoints) {
        endpoint.interface = number;
        bytes.insert(bytes.end(),
                     {7, kEndpointType, endpoint.address, static_cast<std::uint8_t>(endpoint.type)});
        append16(bytes, endpoint.packetSize);
        bytes.push_back(endpoint.interval_ms);
        descriptors.endpoints.push_back(endpoint);
    }
}

}  // namespace

UsbDescriptors buildUsbDescriptors(const UsbDeviceDescription& description) {
    UsbDescriptors descriptors;
    appendDevice(descriptors, description);
    auto& bytes = descriptors.configuration;
    bytes = {9,
             kConfigurationType,
             0,
             0,
             static_cast<std::uint8_t>(description.interfaces.size()),
             kConfigurationValue,
             0,
             kBusPowered,
             static_cast<std::uint8_t>(description.power_mA / kPowerUnit_mA)};
    for (std::size_t i = 0; i < description.interfaces.size(); ++i)
        appendInterface(descriptors, static_cast<std::uint8_t>(i), description.interfaces[i]);
    storeLe16(bytes, 2, static_cast<std::uint16_t>(bytes.size()));
    return descriptors;
}

}  // namespace kickstand
