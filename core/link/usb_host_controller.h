#pragma once

#include <functional>
#include <memory>

#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"
#include "core/link/usb_types.h"

namespace kickstand {

/// How a simulated bus behaves.
struct UsbBusOptions {
    /// Polls interrupt endpoints in every frame instead of once per their interval.
    bool everyFrame = false;
};

/// The host controller of a simulated device: the loopback and the USB/IP server both drive a device model
/// through it. It keeps the pace of a full-speed bus: time is cut into frames of 1 ms on the scheduler's
/// clock, and at the end of each every endpoint moves at most one packet and one control transfer is done; an
/// interrupt endpoint takes part once per its interval. A waiting IN transfer whose endpoint has answered Nak
/// costs nothing until the device says that it is ready; an OUT packet that was refused is offered again at
/// the endpoint's next turn. A transfer longer than a packet takes a packet a turn; an IN transfer ends with
/// the first short one.
///
/// One thread, the scheduler's. Every transfer gets exactly one callback, never from inside the call that
/// asked for it nor while the model is being asked; destroying the controller silences it.
class UsbHostController {
  public:
    /// `scheduler` is the one that the model was made with. Both must outlive the controller, which is the
    /// model's listener from now on.
    UsbHostController(Scheduler& scheduler, UsbDeviceModel& model, UsbBusOptions options = {});
    ~UsbHostController();
    UsbHostController(const UsbHostController&) = delete;
    UsbHostController& operator=(const UsbHostController&) = delete;

    /// A control transfer, done in its turn. For OUT `data` is copied; for IN at most setup.length bytes come
    /// back.
    UsbTransferId control(const UsbSetup& setup, ByteView data, UsbCallback done);
    /// Sends `data` in packets, one empty packet where it has no bytes. With `zeroPacket` an empty one
    /// follows a last packet of full size. The endpoint must be one of the descriptors' (else Failed).
    UsbTransferId out(std::uint8_t endpoint, ByteView data, bool zeroPacket, UsbCallback done);
    /// Takes at most `size` bytes: up to a short packet. A packet that is longer than the room left ends it
    /// with Overflow.
    UsbTransferId in(std::uint8_t endpoint, std::size_t size, UsbCallback done);
    /// Ends a transfer with `status`; `actual` is what had moved before. False when it has ended already.
    bool cancel(UsbTransferId id, UsbStatus status = UsbStatus::Cancelled);
    /// Ends all that wait with `status`.
    void cancelAll(UsbStatus status);
    /// Transfers that wait.
    std::size_t waiting() const;

    /// Hears when the device is plugged in or pulled out. In the latter case every transfer has ended with
    /// NoDevice before. One listener.
    void setAttachedListener(std::function<void(bool attached)> listener);
    /// Calls back after everything that has ended so far has been told.
    void later(std::function<void()> callback);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace kickstand
