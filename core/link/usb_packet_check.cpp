#include "core/link/usb_packet_check.h"

#include <algorithm>

namespace kickstand {

Result<void> checkUsbPacket(std::span<const UsbEndpointInfo> endpoints, std::uint8_t endpoint,
                            UsbDirection direction, std::size_t size) {
    const auto found =
        std::find_if(endpoints.begin(), endpoints.end(),
                     [endpoint](const UsbEndpointInfo& info) { return info.address == endpoint; });
    Error error;
    error.subject = "endpoint";
    error.endpoint = endpoint;
    const bool carriesPackets =
        found != endpoints.end() &&
        (found->type == UsbEndpointInfo::Type::Interrupt || found->type == UsbEndpointInfo::Type::Bulk);
    if (!carriesPackets || isInEndpoint(endpoint) != (direction == UsbDirection::In)) {
        error.code = Errc::BadArgument;
        return fail(std::move(error));
    }
    // An OUT packet may be empty; asking for an empty IN packet makes no sense.
    const std::size_t lowest = direction == UsbDirection::In ? 1 : 0;
    if (size < lowest || size > found->packetSize) {
        error.code = Errc::OutOfRange;
        error.subject = "packet size";
        error.lowest = static_cast<std::int64_t>(lowest);
        error.highest = found->packetSize;
        error.got = static_cast<std::int64_t>(size);
        return fail(std::move(error));
    }
    return {};
}

}  // namespace kickstand
