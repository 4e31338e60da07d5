#include "core/link/usbip/usbip_setup.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

constexpr std::uint8_t kFromDevice = 0x80;
constexpr std::uint8_t kGetDescriptor = 6;
constexpr std::uint8_t kSetConfiguration = 9;
constexpr std::uint8_t kDeviceType = 1;
constexpr std::uint8_t kConfigurationType = 2;
constexpr std::uint8_t kStringType = 3;
constexpr std::uint16_t kLongestString = 255;

}  // namespace

UsbipSetup::UsbipSetup(UsbipClient& client, const UsbMatch& match, std::string port, Done done)
    : client_(client), match_(match), done_(std::move(done)) {
    device_.info.port = std::move(port);
    read(kDeviceType, 0, 0, kDeviceDescriptorBytes, &UsbipSetup::deviceRead);
}

void UsbipSetup::read(std::uint8_t type, std::uint8_t index, std::uint16_t language, std::uint16_t length,
                      Next next) {
    UsbSetup setup;
    setup.requestType = kFromDevice;
    setup.request = kGetDescriptor;
    setup.value = static_cast<std::uint16_t>(type << 8 | index);
    setup.index = language;
    setup.length = length;
    // A device need not have strings.
    request(setup, type == kStringType, "a descriptor", next);
}

void UsbipSetup::readText(std::uint8_t index, Next next) {
    if (index == 0) return (this->*next)({});
    read(kStringType, index, language_, kLongestString, next);
}

void UsbipSetup::configure(std::uint16_t value, Next next) {
    UsbSetup setup;
    setup.request = kSetConfiguration;
    setup.value = value;
    request(setup, false, "a configuration", next);
}

void UsbipSetup::request(const UsbSetup& setup, bool mayRefuse, const char* what, Next next) {
    client_.control(setup, {}, [this, mayRefuse, what, next](const UsbCompletion& completion) {
        if (completion.status == UsbStatus::Completed) return (this->*next)(completion.data);
        if (completion.status == UsbStatus::Stalled && mayRefuse) return (this->*next)({});
        const bool gone = completion.status == UsbStatus::NoDevice;
        std::string detail = std::string(what) + ": " + name(completion.status);
        finish(fail(gone ? Errc::Disconnected : Errc::Io, device_.info.port, std::move(detail)));
    });
}

void UsbipSetup::finish(Result<UsbipDevice> result) {
    // Not from the member: the callback may destroy this.
    const Done done = std::exchange(done_, nullptr);
    done(std::move(result));
}

void UsbipSetup::deviceRead(ByteView data) {
    auto facts = readDeviceDescriptor(data);
    if (!facts) return finish(fail(std::move(facts.error())));
    facts_ = *facts;
    device_.info.vendor = facts_.vendor;
    device_.info.product = facts_.product;
    device_.info.release = facts_.release;
    if (!match_.takes(facts_.vendor, facts_.product))
        return finish(fail(Errc::BadArgument, device_.info.port, "another kind of device"));
    read(kConfigurationType, 0, 0, kConfigurationHeaderBytes, &UsbipSetup::headerRead);
}

void UsbipSetup::headerRead(ByteView data) {
    const auto length = readConfigurationLength(data);
    if (!length) return finish(fail(length.error()));
    read(kConfigurationType, 0, 0, *length, &UsbipSetup::configurationRead);
}

void UsbipSetup::configurationRead(ByteView data) {
    auto facts = readConfigurationDescriptor(data);
    if (!facts) return finish(fail(std::move(facts.error())));
    const auto isIn = [](const std::vector<std::uint8_t>& numbers, std::uint8_t number) {
        return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
    };
    for (const std::uint8_t number : match_.interfaces) {
        if (!isIn(facts->interfaces, number))
            return done_(
                fail(Errc::Io, device_.info.port, "the device has no interface " + std::to_string(number)));
    }
    for (const UsbEndpointInfo& endpoint : facts->endpoints) {
        if (isIn(match_.interfaces, endpoint.interface)) device_.endpoints.push_back(endpoint);
    }
    if (facts_.manufacturer == 0 && facts_.productName == 0) return configure(0, &UsbipSetup::unconfigured);
    read(kStringType, 0, 0, kLongestString, &UsbipSetup::languagesRead);
}

void UsbipSetup::languagesRead(ByteView data) {
    language_ = readFirstLanguage(data);
    readText(facts_.manufacturer, &UsbipSetup::manufacturerRead);
}

void UsbipSetup::manufacturerRead(ByteView data) {
    device_.info.manufacturer = readStringDescriptor(data);
    readText(facts_.productName, &UsbipSetup::productNameRead);
}

void UsbipSetup::productNameRead(ByteView data) {
    device_.info.productName = readStringDescriptor(data);
    configure(0, &UsbipSetup::unconfigured);
}

void UsbipSetup::unconfigured(ByteView) {
    configure(1, &UsbipSetup::configured);
}

void UsbipSetup::configured(ByteView) {
    finish(std::move(device_));
}

}  // namespace kickstand
