#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/error.h"
#include "core/base/time.h"

namespace kickstand {

/// How a transfer ended.
enum class UsbStatus : std::uint8_t {
    Completed,
    Stalled,
    TimedOut,   ///< The deadline given with it passed; the transfer was cancelled.
    Cancelled,  ///< cancel() or close() ended it.
    NoDevice,   ///< The device is gone.
    Overflow,   ///< The device sent more than was asked for.
    Failed,     ///< Anything else that the host controller reports.
};

/// The eight bytes that begin a control transfer (USB 2.0, 9.3).
struct UsbSetup {
    std::uint8_t requestType = 0;
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    std::uint16_t length = 0;

    bool isIn() const { return (requestType & 0x80) != 0; }
    friend bool operator==(const UsbSetup&, const UsbSetup&) = default;
};

/// Which device is meant.
struct UsbMatch {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::optional<std::uint16_t> otherProduct{};  ///< One that will do as well.
    std::optional<std::string> port;  ///< Its place on the bus, "1-2.3"; needed only where several match.
    std::vector<std::uint8_t> interfaces;  ///< The interfaces to claim.

    /// Whether a device with these numbers is meant, wherever it is plugged in.
    bool takes(std::uint16_t deviceVendor, std::uint16_t deviceProduct) const {
        return deviceVendor == vendor && (deviceProduct == product || deviceProduct == otherProduct);
    }
};

/// A device as it presented itself.
struct UsbDeviceInfo {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint16_t release = 0;  ///< bcdDevice: 0x0100 is 1.00.
    std::string port;           ///< "1-2.3"; empty where there is no bus.
    std::string manufacturer;   ///< Empty where it could not be read, as without permission.
    std::string productName;

    friend bool operator==(const UsbDeviceInfo&, const UsbDeviceInfo&) = default;
};

/// The end of one transfer. `data` holds what came in, and only during the callback; for OUT it is empty.
struct UsbCompletion {
    UsbStatus status = UsbStatus::Failed;
    ByteView data{};
    std::size_t actual = 0;  ///< Bytes that really moved.
};
using UsbCallback = std::function<void(const UsbCompletion&)>;

/// What a link knows of the way to its device; nothing where the device hangs on this machine's own bus.
struct UsbLinkHealth {
    std::optional<Duration> roundTrip{};  ///< How long the server at the other end took to answer, lately.
    std::string lostBecause{};            ///< Why the device was lost last, where that is known.
};

/// Identifies a transfer of one link. Zero is never given out.
using UsbTransferId = std::uint64_t;

/// Whether an endpoint address (0x85) is of the IN direction. Any thread.
constexpr bool isInEndpoint(std::uint8_t endpoint) {
    return (endpoint & 0x80) != 0;
}

/// "completed", "stalled", …: stable names for logs and JSON. Any thread.
const char* name(UsbStatus status);

}  // namespace kickstand
