#pragma once

#include <functional>
#include <memory>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/socket/byte_stream.h"
#include "core/link/usb_link.h"
#include "core/link/usbip/usbip_address.h"

namespace kickstand {

/// Makes a connection to the server; its callback comes on the scheduler's thread, never from inside the
/// call.
using UsbipConnect = std::function<void(std::function<void(Result<std::unique_ptr<ByteStream>>)> done)>;

/// A device on a USB/IP server, driven from this program without a kernel in between: one of this project's
/// simulators, or a real device on a machine that runs usbipd. Behaves as UsbLink says; besides:
/// - open() errors NoDevice also where nobody answers at host and port, ClaimedElsewhere where the server
/// says
///   that the device is busy, BadArgument where the device has another vendor or product than `match` says,
///   Malformed where server or device speak nonsense. UsbMatch::port is not looked at.
/// - UsbDeviceInfo::port is "HOST:PORT/BUSID".
/// - When the connection is lost every transfer ends NoDevice and the presence listener hears false. A server
///   that has been silent for three seconds while something waits counts as lost.
/// - While the link is not open and has a presence listener, the server is asked for its list twice a second.
///   Some servers leave out devices that are in use; then one that is given back counts as coming.
///
/// `scheduler` must outlive it.
std::unique_ptr<UsbLink> makeUsbipLink(Scheduler& scheduler, const UsbipAddress& address, UsbMatch match);

/// The same over connections that somebody else makes.
std::unique_ptr<UsbLink> makeUsbipLink(Scheduler& scheduler, const UsbipAddress& address, UsbMatch match,
                                       UsbipConnect connect);

}  // namespace kickstand
