#include "app/composition/usbip_links.h"

#include "core/link/usbip/usbip_link.h"
#include "core/thunderbots/wire/dongle.h"

namespace kickstand {

namespace wire = thunderbots::wire;

bool isUsbip(const LinkUri& uri) {
    return uri.scheme == "usbip";
}

Result<void> checkUsbipLink(const LinkUri& uri) {
    if (auto address = parseUsbipAddress(uri.target); !address) return fail(std::move(address.error()));
    if (!uri.options.empty()) return fail(Errc::BadUri, toString(uri), "usbip:HOST[:PORT]/BUSID");
    return {};
}

Result<std::unique_ptr<UsbLink>> makeUsbipLink(const LinkUri& uri, Scheduler& scheduler) {
    if (auto right = checkUsbipLink(uri); !right) return fail(std::move(right.error()));
    UsbMatch match;
    match.vendor = wire::kVendorId;
    match.product = wire::kDongleProductId;
    match.otherProduct = wire::kCableProductId;
    match.interfaces = {wire::kLocalDataInterface, wire::kMainTransportInterface};
    return makeUsbipLink(scheduler, *parseUsbipAddress(uri.target), std::move(match));
}

}  // namespace kickstand
