#include "app/composition/serial_links.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

#include "core/link/serial/serial_byte_link.h"
#include "core/link/serial/serial_ports.h"

namespace kickstand {
namespace {

struct Protocol {
    std::string_view name;
    Baud baud;       ///< Where the URI names none.
    bool needsPort;  ///< Or looks at every port there is.
};
constexpr std::array kProtocols{Protocol{"smartdevice", 115200, false}, Protocol{"coach", 9600, true},
                                Protocol{"motionplan", 115200, true}};
constexpr char kForm[] =
    "serial:PATH?protocol=smartdevice|coach|motionplan&baud=115200, and serial: for smart devices at every "
    "port";
constexpr Baud kHighestBaud = std::numeric_limits<int>::max();

const Protocol* protocolOf(const LinkUri& uri) {
    const auto named = uri.options.find("protocol");
    if (named == uri.options.end()) return &kProtocols[0];
    const auto found = std::ranges::find(kProtocols, named->second, &Protocol::name);
    return found == kProtocols.end() ? nullptr : &*found;
}

/// Empty for what is no speed.
std::optional<Baud> baudOf(const LinkUri& uri, const Protocol& protocol) {
    const auto named = uri.options.find("baud");
    if (named == uri.options.end()) return protocol.baud;
    const std::string& text = named->second;
    Baud baud = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), baud);
    if (error != std::errc() || end != text.data() + text.size() || baud == 0 || baud > kHighestBaud)
        return std::nullopt;
    return baud;
}

}  // namespace

bool isSerial(const LinkUri& uri) {
    return uri.scheme == "serial";
}

Result<void> checkSerialLink(const LinkUri& uri) {
    const Protocol* protocol = protocolOf(uri);
    const bool known = std::ranges::all_of(
        uri.options, [](const auto& option) { return option.first == "protocol" || option.first == "baud"; });
    if (!isSerial(uri) || !known || protocol == nullptr || !baudOf(uri, *protocol) ||
        (protocol->needsPort && uri.target.empty()))
        return fail(Errc::BadUri, toString(uri), kForm);
    return {};
}

Result<ProvidedByteLink> makeSerialLink(const LinkUri& uri, Scheduler& scheduler) {
    if (auto right = checkSerialLink(uri); !right) return fail(std::move(right.error()));
    if (uri.target.empty()) return fail(Errc::BadUri, toString(uri), kForm);
    ProvidedByteLink provided;
    provided.link = makeSerialByteLink(scheduler, uri.target, *baudOf(uri, *protocolOf(uri)));
    return provided;
}

Result<ProvidedBytePorts> makeSerialPortList(const LinkUri& uri, Scheduler& scheduler) {
    if (auto right = checkSerialLink(uri); !right) return fail(std::move(right.error()));
    ProvidedBytePorts provided;
    provided.ports = makeSerialPorts(scheduler, uri.target);
    return provided;
}

}  // namespace kickstand
