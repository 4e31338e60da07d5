#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/link/usb_device_model.h"

// Descriptors as a device sends them (USB 2.0, 9.6), which may be anything. Any thread.

namespace kickstand {

/// The longest configuration that is read; a device of this project has some hundred bytes.
constexpr std::size_t kMaxConfigurationBytes = 4096;
constexpr std::size_t kDeviceDescriptorBytes = 18;
/// The front of a configuration descriptor, which says how long the whole is.
constexpr std::size_t kConfigurationHeaderBytes = 9;

/// What a device says of itself; strings by their index, 0 for none.
struct UsbDeviceFacts {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint16_t release = 0;
    std::uint8_t manufacturer = 0;
    std::uint8_t productName = 0;
};

/// What a configuration has: first settings of interfaces alone.
struct UsbConfigurationFacts {
    std::vector<std::uint8_t> interfaces;
    std::vector<UsbEndpointInfo> endpoints;
};

/// Errors: Malformed with what is wrong.
Result<UsbDeviceFacts> readDeviceDescriptor(ByteView bytes);
/// The length of the configuration whose descriptor begins so. Errors: Malformed, also for one longer than
/// kMaxConfigurationBytes.
Result<std::uint16_t> readConfigurationLength(ByteView bytes);
/// The whole configuration with its interfaces and endpoints. Errors: Malformed.
Result<UsbConfigurationFacts> readConfigurationDescriptor(ByteView bytes);
/// The text of a string descriptor as UTF-8, without control characters; empty where it is none.
std::string readStringDescriptor(ByteView bytes);
/// The first language of string descriptor 0; English of the United States where it names none.
std::uint16_t readFirstLanguage(ByteView bytes);

}  // namespace kickstand
