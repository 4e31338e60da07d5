#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/usb_link.h"

namespace kickstand {

/// Which device of which server.
struct UsbipAddress {
    std::string host;  ///< Name or address; without brackets where it is IPv6.
    std::uint16_t port = 3240;
    std::string busId;  ///< "1-1".
    friend bool operator==(const UsbipAddress&, const UsbipAddress&) = default;
};

/// Takes the target of a `usbip:` URI apart: HOST[:PORT]/BUSID, IPv6 in brackets. Errors: BadUri with the
/// form in `detail`. Any thread.
Result<UsbipAddress> parseUsbipAddress(const std::string& target);

/// A device on a USB/IP server, driven from this program without a kernel in between: one of this project's
/// simulators, or a real device on a machine that runs usbipd. Behaves as UsbLink says; besides:
/// - open() errors NoDevice also where nobody answers at host and port, ClaimedElsewhere where the server
/// says
///   that the device is busy, BadArgument where the device has another vendor or product than `match` says.
/// - UsbDeviceInfo::port is "HOST:PORT/BUSID".
/// - When the connection is lost every transfer ends NoDevice and the presence listener hears false. While
/// the
///   link is not open the server is asked twice a second whether the device is there.
/// - A server that answers nothing for `silence` while control transfers wait counts as lost.
std::unique_ptr<UsbLink> makeUsbipLink(Scheduler& scheduler, UsbipAddress address, UsbMatch match);

}  // namespace kickstand
