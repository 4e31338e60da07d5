#pragma once

#include <deque>
#include <map>
#include <memory>

#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"
#include "core/link/usb_link.h"
#include "core/link/usb_packet_check.h"

namespace kickstand {

/// How a loopback behaves.
struct LoopbackOptions {
    /// Polls interrupt endpoints in every frame instead of once per their interval.
    bool everyFrame = false;
    /// The place on the bus that the device claims to have.
    std::string port{};
};

/// The host controller of a simulated device, in this process. It keeps the pace of a full-speed bus: time is
/// cut into frames of 1 ms on the scheduler's clock, and at the end of each every endpoint moves at most one
/// packet and one control transfer is done; an interrupt endpoint takes part once per its interval. A waiting
/// IN transfer whose endpoint has answered Nak costs nothing until the device says that it is ready; an OUT
/// packet that was refused is offered again at the endpoint's next turn.
class LoopbackUsbLink final : public UsbLink, private UsbDeviceListener {
  public:
    /// `scheduler` is the one that the model was made with. Both must outlive the link.
    LoopbackUsbLink(Scheduler& scheduler, UsbDeviceModel& model, LoopbackOptions options = {});
    ~LoopbackUsbLink() override;
    LoopbackUsbLink(const LoopbackUsbLink&) = delete;
    LoopbackUsbLink& operator=(const LoopbackUsbLink&) = delete;

    void open(std::function<void(Result<UsbDeviceInfo>)> done) override;
    void close(std::function<void()> done) override;
    void control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) override;
    Result<UsbTransferId> submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) override;
    Result<UsbTransferId> submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) override;
    void cancel(UsbTransferId id) override;
    void clearHalt(std::uint8_t endpoint, UsbCallback done) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;

  private:
    using Frame = std::int64_t;
    enum class State : std::uint8_t { Closed, Opening, Open, Closing, Losing };

    struct Transfer {
        UsbTransferId id = 0;
        std::vector<std::uint8_t> data;  ///< What is to be sent.
        std::size_t size = 0;            ///< What is asked for at most.
        UsbCallback done;
    };
    struct Pipe {
        UsbEndpointInfo info;
        bool ready = true;         ///< Has not answered Nak since it last said that it was ready.
        std::optional<Frame> due;  ///< When it has its turn; none while there is nothing to move.
        std::deque<Transfer> queue;
    };
    struct Control {
        UsbSetup setup;
        Transfer transfer;
        TimerId deadline = 0;
    };

    void endpointReady(std::uint8_t endpoint) override;
    void attachedChanged(bool attached) override;

    Frame currentFrame() const;
    void arm();
    void runFrame();
    void openStep();
    void finishOpen(Result<UsbDeviceInfo> result);
    Result<UsbDeviceInfo> configured();
    void serviceControl();
    void servicePipe(Pipe& pipe);
    Result<UsbTransferId> submit(std::uint8_t endpoint, UsbDirection direction, Transfer transfer);
    void queueControl(Control control, Duration deadline);
    void endAll(UsbStatus status);
    void finish(UsbCallback done, UsbStatus status, std::size_t actual = 0, ByteView data = {});
    void later(std::function<void()> callback);
    void deliver();

    Scheduler& scheduler_;
    UsbDeviceModel& model_;
    const LoopbackOptions options_;
    State state_ = State::Closed;
    std::uint8_t nextConfiguration_ = 0;
    std::function<void(Result<UsbDeviceInfo>)> opened_;
    std::function<void(bool)> presence_;
    std::map<std::uint8_t, Pipe> pipes_;
    std::deque<Control> controls_;
    std::vector<std::uint8_t> packet_;
    UsbTransferId lastId_ = 0;
    TimerId frameTimer_ = 0;
    Frame armedFor_ = 0;
    std::deque<std::function<void()>> outbox_;
    bool deliveryAsked_ = false;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
};

}  // namespace kickstand
