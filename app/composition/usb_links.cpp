#include "app/composition/usb_links.h"

#include <utility>

#include "app/composition/device_holder.h"
#include "app/composition/udev_rule.h"
#include "core/link/usb/libusb_link.h"
#include "core/link/usb/usb_probe.h"
#include "core/thunderbots/wire/dongle.h"

namespace kickstand {
namespace {

namespace wire = thunderbots::wire;

struct Kind {
    const char* scheme;
    std::uint16_t product;
};
constexpr Kind kKinds[] = {{"usb", wire::kDongleProductId}, {"usb-cable", wire::kCableProductId}};

const Kind* kindOf(const LinkUri& uri) {
    for (const Kind& kind : kKinds) {
        if (uri.scheme == kind.scheme) return &kind;
    }
    return nullptr;
}

UsbMatch matchOf(const Kind& kind) {
    UsbMatch match;
    match.vendor = wire::kVendorId;
    match.product = kind.product;
    match.interfaces = {wire::kLocalDataInterface, wire::kMainTransportInterface};
    return match;
}

std::optional<Error> obstacleOf(const UsbProbe& probe) {
    if (probe.permitted && !probe.claimedElsewhere) return std::nullopt;
    Error error;
    error.code = probe.permitted ? Errc::ClaimedElsewhere : Errc::PermissionDenied;
    error.subject = probe.info.port;
    return error;
}

}  // namespace

bool isHardware(const LinkUri& uri) {
    return kindOf(uri) != nullptr;
}

Result<void> checkHardwareLink(const LinkUri& uri) {
    if (!isHardware(uri) || !uri.target.empty())
        return fail(Errc::BadUri, toString(uri), "usb:, usb:?port=1-2.3, usb-cable:, usb-cable:?port=1-2.3");
    for (const auto& [option, value] : uri.options) {
        if (option != "port" || value.empty()) return fail(Errc::BadUri, toString(uri), "port=1-2.3");
    }
    return {};
}

Result<std::unique_ptr<UsbLink>> makeHardwareLink(const LinkUri& uri, Scheduler& scheduler) {
    if (auto right = checkHardwareLink(uri); !right) return fail(std::move(right.error()));
    UsbMatch match = matchOf(*kindOf(uri));
    if (const auto port = uri.options.find("port"); port != uri.options.end()) match.port = port->second;
    return makeLibusbLink(scheduler, std::move(match));
}

std::vector<FoundDevice> findHardware() {
    std::vector<FoundDevice> found;
    for (const Kind& kind : kKinds) {
        const auto probes = probeUsbDevices(matchOf(kind));
        if (!probes) continue;
        for (const UsbProbe& probe : *probes) {
            LinkUri uri;
            uri.scheme = kind.scheme;
            if (probes->size() > 1) uri.options["port"] = probe.info.port;
            FoundDevice device{std::move(uri), probe.info, obstacleOf(probe)};
            if (device.obstacle && device.obstacle->code == Errc::ClaimedElsewhere)
                device.holder = findHolder(probe.info.port);
            device.rule = findUdevRule(probe.info.vendor, probe.info.product).value_or(std::string());
            found.push_back(std::move(device));
        }
    }
    return found;
}

}  // namespace kickstand
