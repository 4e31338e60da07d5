#include "core/link/usbip/usb_descriptor_reader.h"

#include <algorithm>

namespace kickstand {
namespace {

// Descriptor types (USB 2.0, table 9-5), and the least lengths of those that are read.
constexpr std::uint8_t kDeviceType = 1;
constexpr std::uint8_t kConfigurationType = 2;
constexpr std::uint8_t kStringType = 3;
constexpr std::uint8_t kInterfaceType = 4;
constexpr std::uint8_t kEndpointType = 5;
constexpr std::size_t kHeaderBytes = 2;
constexpr std::size_t kInterfaceBytes = 9;
constexpr std::size_t kEndpointBytes = 7;

/// The part of wMaxPacketSize that is the size (table 9-13).
constexpr std::uint16_t kPacketSizeMask = 0x07FF;
constexpr std::uint8_t kTypeMask = 0x03;
constexpr std::uint8_t kEndpointNumber = 0x0F;
constexpr std::uint16_t kEnglish = 0x0409;
constexpr char32_t kReplacement = 0xFFFD;

tl::unexpected<Error> malformed(const char* why) {
    return fail(Errc::Malformed, "usb descriptor", why);
}

bool begins(ByteView bytes, std::uint8_t type, std::size_t least) {
    return bytes.size() >= least && bytes[0] >= least && bytes[1] == type;
}

void appendUtf8(std::string& text, char32_t character) {
    const auto append = [&text](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (character < 0x80) {
        append(character);
    } else if (character < 0x800) {
        append(0xC0 | character >> 6);
        append(0x80 | (character & 0x3F));
    } else if (character < 0x10000) {
        append(0xE0 | character >> 12);
        append(0x80 | (character >> 6 & 0x3F));
        append(0x80 | (character & 0x3F));
    } else {
        append(0xF0 | character >> 18);
        append(0x80 | (character >> 12 & 0x3F));
        append(0x80 | (character >> 6 & 0x3F));
        append(0x80 | (character & 0x3F));
    }
}

bool isHighSurrogate(char32_t unit) {
    return unit >= 0xD800 && unit < 0xDC00;
}
bool isLowSurrogate(char32_t unit) {
    return unit >= 0xDC00 && unit < 0xE000;
}
bool isControl(char32_t character) {
    return character < 0x20 || (character >= 0x7F && character < 0xA0);
}

/// Walks the descriptors of a configuration.
class ConfigurationReader {
  public:
    Result<UsbConfigurationFacts> read(ByteView bytes) {
        while (!bytes.empty()) {
            if (bytes.size() < kHeaderBytes || bytes[0] < kHeaderBytes || bytes[0] > bytes.size())
                return malformed("a descriptor longer than what holds it");
            const ByteView one = bytes.first(bytes[0]);
            if (const auto taken = take(one); !taken) return fail(taken.error());
            bytes = bytes.subspan(one.size());
        }
        return std::move(facts_);
    }

  private:
    /// Descriptors of other types are a class's or a vendor's own.
    Result<void> take(ByteView one) {
        if (one[1] == kInterfaceType) return takeInterface(one);
        if (one[1] == kEndpointType && firstSetting_) return takeEndpoint(one);
        return {};
    }

    Result<void> takeInterface(ByteView one) {
        if (one.size() < kInterfaceBytes) return malformed("an interface descriptor too short");
        interface_ = one[2];
        firstSetting_ = one[3] == 0;
        if (!firstSetting_) return {};
        if (std::find(facts_.interfaces.begin(), facts_.interfaces.end(), interface_) !=
            facts_.interfaces.end())
            return malformed("an interface twice");
        facts_.interfaces.push_back(interface_);
        return {};
    }

    Result<void> takeEndpoint(ByteView one) {
        if (one.size() < kEndpointBytes) return malformed("an endpoint descriptor too short");
        UsbEndpointInfo info;
        info.address = one[2];
        info.type = static_cast<UsbEndpointInfo::Type>(one[3] & kTypeMask);
        info.packetSize = loadLe16(one, 4) & kPacketSizeMask;
        info.interval_ms = one[6];
        info.interface = interface_;
        if ((info.address & ~0x80 & ~kEndpointNumber) != 0 || (info.address & kEndpointNumber) == 0)
            return malformed("an endpoint that no device can have");
        const bool known =
            std::any_of(facts_.endpoints.begin(), facts_.endpoints.end(),
                        [&](const UsbEndpointInfo& other) { return other.address == info.address; });
        if (known) return malformed("an endpoint twice");
        facts_.endpoints.push_back(info);
        return {};
    }

    UsbConfigurationFacts facts_;
    std::uint8_t interface_ = 0;
    bool firstSetting_ = false;
};

}  // namespace

Result<UsbDeviceFacts> readDeviceDescriptor(ByteView bytes) {
    if (!begins(bytes, kDeviceType, kDeviceDescriptorBytes)) return malformed("not a device descriptor");
    UsbDeviceFacts facts;
    facts.vendor = loadLe16(bytes, 8);
    facts.product = loadLe16(bytes, 10);
    facts.release = loadLe16(bytes, 12);
    facts.manufacturer = bytes[14];
    facts.productName = bytes[15];
    return facts;
}

Result<std::uint16_t> readConfigurationLength(ByteView bytes) {
    if (!begins(bytes, kConfigurationType, kConfigurationHeaderBytes))
        return malformed("not a configuration descriptor");
    const std::uint16_t length = loadLe16(bytes, 2);
    if (length < kConfigurationHeaderBytes || length > kMaxConfigurationBytes)
        return malformed("a configuration of an impossible length");
    return length;
}

Result<UsbConfigurationFacts> readConfigurationDescriptor(ByteView bytes) {
    const auto length = readConfigurationLength(bytes);
    if (!length) return fail(length.error());
    if (bytes.size() < *length) return malformed("a configuration cut short");
    return ConfigurationReader().read(bytes.first(*length));
}

std::string readStringDescriptor(ByteView bytes) {
    std::string text;
    if (!begins(bytes, kStringType, kHeaderBytes)) return text;
    bytes = bytes.first(std::min<std::size_t>(bytes.size(), bytes[0]));
    for (std::size_t at = kHeaderBytes; at + 1 < bytes.size(); at += 2) {
        char32_t character = loadLe16(bytes, at);
        const bool paired =
            isHighSurrogate(character) && at + 3 < bytes.size() && isLowSurrogate(loadLe16(bytes, at + 2));
        if (paired) {
            at += 2;
            character = 0x10000 + ((character - 0xD800) << 10) + (loadLe16(bytes, at) - 0xDC00U);
        } else if (isHighSurrogate(character) || isLowSurrogate(character)) {
            character = kReplacement;
        }
        if (!isControl(character)) appendUtf8(text, character);
    }
    return text;
}

std::uint16_t readFirstLanguage(ByteView bytes) {
    if (!begins(bytes, kStringType, kHeaderBytes + 2)) return kEnglish;
    return loadLe16(bytes, kHeaderBytes);
}

}  // namespace kickstand
