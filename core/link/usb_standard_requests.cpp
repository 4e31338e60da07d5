#include "core/link/usb_standard_requests.h"

#include <algorithm>

namespace kickstand {
namespace {

// bmRequestType (USB 2.0, table 9-2).
constexpr std::uint8_t kTypeMask = 0x60;
constexpr std::uint8_t kRecipientMask = 0x1F;
constexpr std::uint8_t kToDevice = 0;
constexpr std::uint8_t kToInterface = 1;
constexpr std::uint8_t kToEndpoint = 2;

// bRequest (table 9-4).
constexpr std::uint8_t kGetStatus = 0;
constexpr std::uint8_t kClearFeature = 1;
constexpr std::uint8_t kSetFeature = 3;
constexpr std::uint8_t kSetAddress = 5;
constexpr std::uint8_t kGetDescriptor = 6;
constexpr std::uint8_t kGetConfiguration = 8;
constexpr std::uint8_t kSetConfiguration = 9;
constexpr std::uint8_t kGetInterface = 10;
constexpr std::uint8_t kSetInterface = 11;

// Descriptor types (table 9-5).
constexpr std::uint8_t kDeviceDescriptor = 1;
constexpr std::uint8_t kConfigurationDescriptor = 2;
constexpr std::uint8_t kStringDescriptor = 3;

constexpr std::uint16_t kEndpointHalt = 0;
constexpr std::uint8_t kConfigurationValue = 1;
constexpr std::size_t kLongestDescriptor = 255;
constexpr char32_t kReplacement = 0xFFFD;

/// Takes one character off the front of UTF-8 text; what is not UTF-8 becomes the replacement character.
char32_t takeCharacter(std::string_view& text) {
    const auto first = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    if (first < 0x80) return first;
    const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    if (first < 0xC2 || first > 0xF4 || text.size() < more) return kReplacement;
    char32_t character = first & (0x3FU >> more);
    for (std::size_t i = 0; i < more; ++i) {
        const auto next = static_cast<unsigned char>(text[i]);
        if ((next & 0xC0) != 0x80) return kReplacement;
        character = character << 6 | (next & 0x3FU);
    }
    text.remove_prefix(more);
    const bool surrogate = character >= 0xD800 && character <= 0xDFFF;
    return surrogate || character > 0x10FFFF ? kReplacement : character;
}

void append16(std::vector<std::uint8_t>& bytes, char32_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

/// A string descriptor: length, type, UTF-16LE. Ends before the character that would not fit.
std::vector<std::uint8_t> stringDescriptor(std::string_view text) {
    std::vector<std::uint8_t> bytes{0, kStringDescriptor};
    while (!text.empty()) {
        const char32_t character = takeCharacter(text);
        const bool pair = character > 0xFFFF;
        if (bytes.size() + (pair ? 4 : 2) > kLongestDescriptor) break;
        if (pair) {
            append16(bytes, 0xD800 + ((character - 0x10000) >> 10));
            append16(bytes, 0xDC00 + ((character - 0x10000) & 0x3FF));
        } else {
            append16(bytes, character);
        }
    }
    bytes[0] = static_cast<std::uint8_t>(bytes.size());
    return bytes;
}

}  // namespace

UsbStandardRequests::UsbStandardRequests(const UsbDescriptors& descriptors, Hooks hooks)
    : descriptors_(descriptors), hooks_(std::move(hooks)) {}

std::optional<UsbHandshake> UsbStandardRequests::handle(const UsbSetup& setup,
                                                        std::vector<std::uint8_t>& in) {
    if ((setup.requestType & kTypeMask) != 0) return std::nullopt;
    in.clear();
    bool taken = false;
    switch (setup.requestType & kRecipientMask) {
        case kToDevice:
            taken = device(setup, in);
            break;
        case kToInterface:
            taken = interface(setup, in);
            break;
        case kToEndpoint:
            taken = endpoint(setup, in);
            break;
        default:
            break;
    }
    return taken ? UsbHandshake::Ack : UsbHandshake::Stall;
}

void UsbStandardRequests::reset() {
    configuration_ = 0;
    halted_.clear();
}

bool UsbStandardRequests::device(const UsbSetup& setup, std::vector<std::uint8_t>& in) {
    if (setup.isIn()) {
        switch (setup.request) {
            case kGetStatus:
                in = {0, 0};
                return true;
            case kGetDescriptor:
                return descriptor(setup, in);
            case kGetConfiguration:
                in = {configuration_};
                return true;
            default:
                return false;
        }
    }
    switch (setup.request) {
        case kSetAddress:
            return true;
        case kSetConfiguration:
            return setConfiguration(setup.value);
        default:
            return false;
    }
}

bool UsbStandardRequests::interface(const UsbSetup& setup, std::vector<std::uint8_t>& in) {
    if (configuration_ == 0 || !hasInterface(setup.index)) return false;
    if (setup.isIn() && setup.request == kGetStatus) {
        in = {0, 0};
        return true;
    }
    if (setup.isIn() && setup.request == kGetInterface) {
        in = {0};
        return true;
    }
    if (setup.isIn() || setup.request != kSetInterface || setup.value != 0) return false;
    for (const UsbEndpointInfo& info : descriptors_.endpoints) {
        if (info.interface == setup.index) halted_.erase(info.address);
    }
    return true;
}

bool UsbStandardRequests::endpoint(const UsbSetup& setup, std::vector<std::uint8_t>& in) {
    if (!hasEndpoint(setup.index)) return false;
    const auto address = static_cast<std::uint8_t>(setup.index);
    if (setup.isIn()) {
        if (setup.request != kGetStatus) return false;
        in = {static_cast<std::uint8_t>(isHalted(address) ? 1 : 0), 0};
        return true;
    }
    if (setup.value != kEndpointHalt) return false;
    if (setup.request == kSetFeature) {
        if ((address & 0x0F) != 0) halt(address);
        return true;
    }
    if (setup.request != kClearFeature) return false;
    if (halted_.erase(address) != 0 && hooks_.haltCleared) hooks_.haltCleared(address);
    return true;
}

bool UsbStandardRequests::descriptor(const UsbSetup& setup, std::vector<std::uint8_t>& in) const {
    const auto index = static_cast<std::uint8_t>(setup.value);
    switch (setup.value >> 8) {
        case kDeviceDescriptor:
            in = descriptors_.device;
            return true;
        case kConfigurationDescriptor:
            if (index != 0) return false;
            in = descriptors_.configuration;
            return true;
        case kStringDescriptor: {
            if (index == 0) {
                in = {4, kStringDescriptor, 0x09, 0x04};  // One language: English, United States.
                return true;
            }
            const auto found = descriptors_.strings.find(index);
            if (found == descriptors_.strings.end()) return false;
            in = stringDescriptor(found->second);
            return true;
        }
        default:
            return false;
    }
}

bool UsbStandardRequests::setConfiguration(std::uint16_t value) {
    if (value != 0 && value != kConfigurationValue) return false;
    reset();
    configuration_ = static_cast<std::uint8_t>(value);
    if (hooks_.configured) hooks_.configured(configuration_);
    return true;
}

bool UsbStandardRequests::hasEndpoint(std::uint16_t index) const {
    // Endpoint 0 has a status too, and exists before the device is configured.
    if (index == 0x00 || index == 0x80) return true;
    return configuration_ != 0 &&
           std::any_of(descriptors_.endpoints.begin(), descriptors_.endpoints.end(),
                       [index](const UsbEndpointInfo& info) { return info.address == index; });
}

bool UsbStandardRequests::hasInterface(std::uint16_t index) const {
    return std::any_of(descriptors_.endpoints.begin(), descriptors_.endpoints.end(),
                       [index](const UsbEndpointInfo& info) { return info.interface == index; });
}

}  // namespace kickstand
