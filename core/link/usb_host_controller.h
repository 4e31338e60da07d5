#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

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
/// asked for it nor while the model is being asked; destroying the controller, from a callback too, silences
/// it. While the device is unplugged every transfer ends with NoDevice.
class UsbHostController final : private UsbDeviceListener {
  public:
    /// `scheduler` is the one that the model was made with. Both must outlive the controller, which is the
    /// model's listener from now on.
    UsbHostController(Scheduler& scheduler, UsbDeviceModel& model, UsbBusOptions options = {});
    ~UsbHostController() override;
    UsbHostController(const UsbHostController&) = delete;
    UsbHostController& operator=(const UsbHostController&) = delete;

    /// A control transfer, done in its turn. For OUT `data` is copied; for IN at most setup.length bytes come
    /// back. One that the device answers with Nak is asked again, and holds up those behind it.
    UsbTransferId control(const UsbSetup& setup, ByteView data, UsbCallback done);
    /// Sends `data` in packets, one empty packet where it has no bytes. With `zeroPacket` an empty one
    /// follows a last packet of full size. The endpoint must be one of the descriptors' (else Failed).
    UsbTransferId out(std::uint8_t endpoint, ByteView data, bool zeroPacket, UsbCallback done);
    /// Takes at most `size` bytes: up to a short packet. A packet that is longer than the room left ends it
    /// with Overflow. The endpoint as for out().
    UsbTransferId in(std::uint8_t endpoint, std::size_t size, UsbCallback done);
    /// Ends a transfer with `status` and with what had moved before. False when it has ended already, be it
    /// that its callback is still to come.
    bool cancel(UsbTransferId id, UsbStatus status = UsbStatus::Cancelled);
    /// Ends all that wait with `status`.
    void cancelAll(UsbStatus status);
    /// Transfers that have not ended.
    std::size_t waiting() const;

    /// Hears at once when the device is plugged in or pulled out, possibly from inside a call into the model.
    /// In the latter case every transfer has just been ended with NoDevice; use later() to speak after their
    /// callbacks. One listener.
    void setAttachedListener(std::function<void(bool attached)> listener);
    /// Calls back after everything that has ended so far has been told.
    void later(std::function<void()> callback);

  private:
    using Frame = std::int64_t;

    struct Transfer {
        UsbTransferId id = 0;
        std::vector<std::uint8_t> data;  ///< What is to be sent, or what has come in so far.
        std::size_t size = 0;            ///< Of an IN transfer: what is asked for at most.
        std::uint32_t packets = 1;       ///< Of an OUT transfer, as the next.
        std::uint32_t packetsSent = 0;
        UsbCallback done;
    };
    struct Control {
        UsbSetup setup;
        Transfer transfer;
    };
    struct Pipe {
        UsbEndpointInfo info;
        bool ready = true;         ///< Has not answered Nak since it last said that it was ready.
        std::optional<Frame> due;  ///< When it has its turn; none while there is nothing to move.
        std::deque<Transfer> queue;

        std::size_t packetSize() const;
        /// The next packet of an OUT transfer; empty after the last byte.
        ByteView nextPacket(const Transfer& transfer) const;
    };
    /// Something to tell: the end of a transfer, or what was asked for by later().
    struct Message {
        UsbCallback done;
        UsbStatus status = UsbStatus::Failed;
        std::size_t actual = 0;
        std::vector<std::uint8_t> data;
        std::function<void()> callback;
    };

    void endpointReady(std::uint8_t endpoint) override;
    void attachedChanged(bool attached) override;

    UsbTransferId submit(Pipe* pipe, Transfer transfer);
    Pipe* pipeAt(std::uint8_t endpoint);
    Frame currentFrame() const;
    void arm();
    void runFrame();
    void serviceControl();
    void servicePipe(Pipe& pipe);
    /// Counts the packet that the device took or gave; true when the transfer has ended with it.
    bool sent(const Pipe& pipe, Transfer& transfer);
    bool received(const Pipe& pipe, Transfer& transfer, std::size_t count);
    /// Each takes the transfer's callback, and what came in, out of it.
    void finish(const Pipe& pipe, Transfer& transfer, UsbStatus status);
    void finishIn(Transfer& transfer, UsbStatus status);
    void finishOut(Transfer& transfer, UsbStatus status, std::size_t actual = 0);
    void tell(Message message);
    void deliver();

    Scheduler& scheduler_;
    UsbDeviceModel& model_;
    const UsbBusOptions options_;
    std::function<void(bool)> attachedListener_;
    std::map<std::uint8_t, Pipe> pipes_;
    std::deque<Control> controls_;
    std::vector<std::uint8_t> packet_;
    UsbTransferId lastId_ = 0;
    std::uint64_t losses_ = 0;  ///< How often the device was pulled out.
    TimerId frameTimer_ = 0;
    Frame armedFor_ = 0;
    std::vector<Message> outbox_;  ///< Emptied as a whole, so that it is made once.
    bool deliveryAsked_ = false;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
};

}  // namespace kickstand
