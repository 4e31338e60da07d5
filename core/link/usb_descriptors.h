#pragma once

#include "core/link/usb_device_model.h"

namespace kickstand {

/// One interface of a device that is described in plain terms. It has no alternate settings.
struct UsbInterfaceDescription {
    std::string name;  ///< Its string; empty for none.
    std::uint8_t interfaceClass = 0xFF;
    std::vector<UsbEndpointInfo> endpoints;  ///< UsbEndpointInfo::interface is filled in by the builder.
};

/// A full-speed USB 2.0 device with one configuration, whose value is 1. Interfaces are numbered from 0 in
/// their order.
struct UsbDeviceDescription {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint16_t release = 0;  ///< bcdDevice: 0x0100 is 1.00.
    std::string manufacturer;   ///< UTF-8; empty for none, as for the next two.
    std::string productName;
    std::string serialNumber;
    std::uint8_t controlPacketSize = 8;  ///< 8, 16, 32 or 64.
    std::uint16_t power_mA = 100;        ///< At most 500.
    std::vector<UsbInterfaceDescription> interfaces;
};

/// The descriptors as they travel (USB 2.0, 9.6). Strings get the indices 1, 2, … in the order manufacturer,
/// product, serial number, interfaces. Any thread.
UsbDescriptors buildUsbDescriptors(const UsbDeviceDescription& description);

}  // namespace kickstand
