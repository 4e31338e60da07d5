#pragma once

#include <span>

#include "core/base/result.h"
#include "core/link/usb_device_model.h"

namespace kickstand {

/// Which way a packet goes, as seen from the host.
enum class UsbDirection : std::uint8_t { Out, In };

/// Whether a packet of `size` bytes may be submitted on `endpoint`: what UsbLink promises of submitOut() and
/// submitIn(), the same for every link. Errors: BadArgument for an endpoint that is not there, goes the other
/// way or is neither interrupt nor bulk; OutOfRange with the bounds for a size that its packets cannot have.
/// Any thread.
Result<void> checkUsbPacket(std::span<const UsbEndpointInfo> endpoints, std::uint8_t endpoint,
                            UsbDirection direction, std::size_t size);

}  // namespace kickstand
