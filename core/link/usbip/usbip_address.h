#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"

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

/// The text that parses to `address`, always with the port. Any thread.
std::string toString(const UsbipAddress& address);

}  // namespace kickstand
