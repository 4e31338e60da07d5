#include "core/link/usbip/usbip_address.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "core/link/usbip/usbip_wire.h"

namespace kickstand {
namespace {

bool isPrintable(char c) {
    return c > 0x20 && c < 0x7F;
}

bool isPlain(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), isPrintable);
}

std::optional<std::uint16_t> parsePort(std::string_view text) {
    std::uint16_t port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    if (error != std::errc() || end != text.data() + text.size() || port == 0) return std::nullopt;
    return port;
}

/// HOST[:PORT] or [IPV6][:PORT].
bool parseServer(std::string_view server, UsbipAddress& address) {
    std::string_view port;
    if (server.starts_with('[')) {
        const std::size_t close = server.find(']');
        if (close == std::string_view::npos) return false;
        address.host = server.substr(1, close - 1);
        port = server.substr(close + 1);
        if (address.host.find(':') == std::string::npos) return false;
    } else {
        const std::size_t colon = server.find(':');
        address.host = server.substr(0, colon);
        port = colon == std::string_view::npos ? std::string_view() : server.substr(colon);
    }
    if (address.host.find_first_of("[]") != std::string::npos || !isPlain(address.host)) return false;
    if (port.empty()) return true;
    if (port.front() != ':') return false;
    const auto number = parsePort(port.substr(1));
    if (number) address.port = *number;
    return number.has_value();
}

}  // namespace

Result<UsbipAddress> parseUsbipAddress(const std::string& target) {
    UsbipAddress address;
    address.port = usbip::kDefaultPort;
    const std::size_t slash = target.find('/');
    if (slash != std::string::npos) address.busId = target.substr(slash + 1);
    const bool good = isPlain(address.busId) && address.busId.size() <= usbip::kMaxBusIdLength &&
                      address.busId.find('/') == std::string::npos &&
                      parseServer(std::string_view(target).substr(0, slash), address);
    if (!good) return fail(Errc::BadUri, "usbip:" + target, "usbip:HOST[:PORT]/BUSID");
    return address;
}

std::string toString(const UsbipAddress& address) {
    const bool isIpv6 = address.host.find(':') != std::string::npos;
    const std::string host = isIpv6 ? "[" + address.host + "]" : address.host;
    return host + ":" + std::to_string(address.port) + "/" + address.busId;
}

}  // namespace kickstand
