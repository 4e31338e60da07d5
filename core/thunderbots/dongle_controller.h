#pragma once

#include <functional>
#include <optional>

#include "core/thunderbots/in_pump.h"
#include "core/thunderbots/message_pipe.h"
#include "core/thunderbots/state_transport.h"
#include "core/thunderbots/wire/dongle.h"

namespace kickstand::thunderbots {

/// Brings a dongle (or a robot on a cable) up, keeps it going and takes it down: start-up, transfers,
/// recovery, replug (protocol 3.4). It decides nothing about robots: that is the session's. Engine thread.
class DongleController {
  public:
    /// `changed` is called after every change of state(), except for those that start() and close() make; no
    /// call of it comes from inside a call to this object's methods.
    DongleController(Scheduler& scheduler, UsbLink& link, const StopLatch& stop,
                     std::function<void()> changed);
    ~DongleController();
    DongleController(const DongleController&) = delete;
    DongleController& operator=(const DongleController&) = delete;

    /// Looks for the device and starts it up, now and after every replug, until close(). `channels` are set
    /// once.
    void start(std::optional<wire::Channels> channels = std::nullopt);
    /// Ends the connection. `done` comes when the link is closed.
    void close(std::function<void()> done);

    LinkState state() const { return state_; }
    /// Why it failed or waits; empty while all is well.
    const std::optional<Error>& error() const { return error_; }
    const UsbDeviceInfo& device() const { return device_; }
    bool isCable() const { return device_.product == wire::kCableProductId; }

    StateTransport& stateTransport() { return stateTransport_; }
    MessagePipe& messages() { return messages_; }
    /// `received` sees every packet of the message IN endpoint (protocol 3.7), after the tap.
    void setMessageListener(std::function<void(ByteView)> received) {
        messageReceived_ = std::move(received);
    }

  private:
    void setState(LinkState state);
    void openLink();
    void opened(std::uint64_t attempt, Result<UsbDeviceInfo> result);
    void presence(bool present);
    void startRadios();
    void request(wire::VendorRequest request, std::uint16_t value, std::function<void(UsbStatus)> done);
    void read(wire::VendorRequest request, std::uint16_t length);
    void requestStatus();
    void statusReceived(ByteView packet);
    void radiosRunning();
    void allBraked();
    void startFailed(Errc code, std::string subject, std::optional<int> radio = std::nullopt);
    void giveUp(Error error);
    void brakeThenFail(Error error);
    void failNow(Error error);
    void stopTransfers(const Error& why);
    void retryLater();
    void armDeadline();

    Scheduler& scheduler_;
    UsbLink& link_;
    std::function<void()> changed_;
    std::function<void(ByteView)> messageReceived_;
    LinkState state_ = LinkState::Idle;
    std::optional<Error> error_;
    UsbDeviceInfo device_;
    std::optional<wire::Channels> channels_;
    bool wanted_ = false;        ///< Between start() and close().
    bool opening_ = false;       ///< The link has been asked to open and has not answered.
    bool appeared_ = false;      ///< A device appeared meanwhile.
    std::uint64_t attempt_ = 0;  ///< Tells late answers of an earlier attempt apart.
    TimerId deadline_ = 0;
    TimerId retry_ = 0;

    StateTransport stateTransport_;
    MessagePipe messages_;
    InPump status_;
    InPump errors_;
    InPump text_;
    InPump stateIn_;
    InPump messageIn_;
};

}  // namespace kickstand::thunderbots
