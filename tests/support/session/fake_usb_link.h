#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/usb_link.h"

namespace kickstand::testing {

/// A USB link whose every transfer ends when and how the test says. It records what it is asked for, in
/// order. Calls back only from the methods that a test calls, never from inside a call of the code under
/// test.
class FakeUsbLink final : public UsbLink {
  public:
    /// A transfer that was asked for and has not ended.
    struct Transfer {
        UsbTransferId id = 0;
        std::vector<std::uint8_t> data;  ///< What is to be sent.
        std::size_t size = 0;            ///< What is asked for at most.
        UsbCallback done;
        bool cancelAsked = false;
    };
    struct Control {
        UsbSetup setup;
        UsbCallback done;
    };

    /// Everything that was asked for, in order: "open", "close", "control 40 03 0000", "in 81", "out 05",
    /// "clear 05", "cancel 06".
    const std::vector<std::string>& log() const { return log_; }
    void clearLog() { log_.clear(); }
    bool isOpen() const { return open_; }
    bool openAsked() const { return opened_ != nullptr; }

    /// Answers open().
    void finishOpen(Result<UsbDeviceInfo> result);
    /// Answers close(): everything pending ends as cancelled first.
    void finishClose();
    /// Transfers of an endpoint that have not ended, oldest first.
    const std::deque<Transfer>& pending(std::uint8_t endpoint) { return pipes_[endpoint]; }
    /// Ends the oldest transfer of an endpoint; `in` is what it brought.
    void complete(std::uint8_t endpoint, UsbStatus status = UsbStatus::Completed, ByteView in = {});
    /// The control transfers that have not ended, oldest first; clearing a halt is not among them.
    const std::deque<Control>& controls() const { return controls_; }
    void completeControl(UsbStatus status = UsbStatus::Completed, ByteView in = {});
    /// Endpoints whose halt is to be cleared, oldest first.
    std::vector<std::uint8_t> clearing() const;
    void completeClear(UsbStatus status = UsbStatus::Completed);
    /// What went out on an endpoint and was taken, in order.
    const std::vector<std::vector<std::uint8_t>>& taken(std::uint8_t endpoint) { return taken_[endpoint]; }
    /// Ends everything with NoDevice and says that the device is gone.
    void unplug();
    /// Says that a device has appeared.
    void appear();
    /// Refuses submissions from now on, as a link does whose loss has not been told yet.
    void refuse() { open_ = false; }

    void open(std::function<void(Result<UsbDeviceInfo>)> done) override;
    void close(std::function<void()> done) override;
    void control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) override;
    Result<UsbTransferId> submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) override;
    Result<UsbTransferId> submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) override;
    void cancel(UsbTransferId id) override;
    void clearHalt(std::uint8_t endpoint, UsbCallback done) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;

  private:
    struct Clear {
        std::uint8_t endpoint = 0;
        UsbCallback done;
    };

    Result<UsbTransferId> submit(std::uint8_t endpoint, Transfer transfer);
    void endAll(UsbStatus status);

    std::vector<std::string> log_;
    bool open_ = false;
    std::function<void(Result<UsbDeviceInfo>)> opened_;
    std::deque<std::function<void()>> closed_;
    std::function<void(bool)> presence_;
    std::map<std::uint8_t, std::deque<Transfer>> pipes_;
    std::map<std::uint8_t, std::vector<std::vector<std::uint8_t>>> taken_;
    std::deque<Control> controls_;
    std::deque<Clear> clears_;
    UsbTransferId lastId_ = 0;
};

}  // namespace kickstand::testing
