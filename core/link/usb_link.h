#pragma once

#include "core/base/result.h"
#include "core/link/usb_types.h"

namespace kickstand {

/// One USB device, as a host program uses it: libusb, USB/IP, or a simulated device in this process. One
/// contract suite (tests/contract) holds for all of them.
///
/// Every method is called on the scheduler's thread that the link was made with, and every callback comes
/// there, never from inside the call that asked for it. What may block happens on a thread of the link's own.
/// Each transfer that was accepted gets exactly one callback, except that destroying the link silences it.
class UsbLink {
  public:
    virtual ~UsbLink() = default;

    /// Finds the device, sets configuration 0 and then 1, and claims its interfaces; what an earlier program
    /// left in the device is gone. Errors: NoDevice, SeveralDevices, PermissionDenied, ClaimedElsewhere, Io;
    /// Disconnected when it vanished meanwhile, Cancelled when close() came meanwhile, BadArgument when the
    /// link is not closed. A link that is closed or lost may be opened again.
    virtual void open(std::function<void(Result<UsbDeviceInfo>)> done) = 0;

    /// Ends all transfers (Cancelled), releases and closes the device; `done` comes after the last of their
    /// callbacks. On a link that is not open, `done` comes at once.
    virtual void close(std::function<void()> done) = 0;

    /// A control transfer on endpoint 0. For OUT, `data` is copied and has setup.length bytes, else the
    /// transfer ends Failed; for IN, at most setup.length bytes come back. `deadline` counts from this call.
    /// On a link that is not open the transfer ends NoDevice.
    virtual void control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) = 0;

    /// Queues one OUT packet (interrupt or bulk), which may be empty. `data` is copied. Packets of an
    /// endpoint go out in order; there is no deadline. Errors: NotConnected; OutOfRange for more than the
    /// endpoint's packet size; BadArgument for an endpoint that does not exist or is an IN endpoint.
    virtual Result<UsbTransferId> submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) = 0;

    /// Asks for one packet of at most `size` bytes and waits for it without a deadline. Errors as
    /// submitOut().
    virtual Result<UsbTransferId> submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) = 0;

    /// Ends a transfer early. Its callback still comes: Cancelled, or how it ended before the cancel reached
    /// it.
    virtual void cancel(UsbTransferId id) = 0;

    /// Clears the stall of an endpoint, at the device and at the host (USB 2.0, 9.4.5). Ends Failed for an
    /// endpoint that is not there, NoDevice on a link that is not open.
    virtual void clearHalt(std::uint8_t endpoint, UsbCallback done) = 0;

    /// Tells when a matching device appears while the link is not open (true), or the opened one vanishes
    /// (false). Before the latter every pending transfer has ended with NoDevice; with it the link counts as
    /// closed. A device that is there from the beginning is not told: open() finds it. One listener.
    virtual void setPresenceListener(std::function<void(bool present)> listener) = 0;

    /// What is known of the way to the device.
    virtual UsbLinkHealth health() const { return {}; }
};

}  // namespace kickstand
