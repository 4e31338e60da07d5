#pragma once

#include <memory>
#include <unordered_map>

#include "core/base/scheduler.h"
#include "core/link/usb_host_controller.h"
#include "core/link/usb_link.h"

namespace kickstand {

/// How a loopback behaves.
struct LoopbackOptions {
    /// Polls interrupt endpoints in every frame instead of once per their interval.
    bool everyFrame = false;
    /// The place on the bus that the device claims to have.
    std::string port{};
};

/// The link to a simulated device in this process, at the pace of UsbHostController.
class LoopbackUsbLink final : public UsbLink {
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
    enum class State : std::uint8_t { Closed, Opening, Open, Closing, Losing };

    void attachedChanged(bool attached);
    void configure(std::uint8_t configuration);
    void configured(std::uint8_t configuration, UsbStatus status);
    void finishOpen(Result<UsbDeviceInfo> result);
    void end(UsbCallback done, UsbStatus status);

    Scheduler& scheduler_;
    UsbDeviceModel& model_;
    const LoopbackOptions options_;
    State state_ = State::Closed;
    std::uint64_t opening_ = 0;  ///< Tells the answers to an earlier open() from those to this one.
    std::function<void(Result<UsbDeviceInfo>)> opened_;
    std::function<void(bool)> presence_;
    std::unordered_map<std::uint64_t, TimerId> deadlines_;  ///< Of control transfers.
    std::uint64_t lastDeadline_ = 0;
    UsbHostController controller_;
};

}  // namespace kickstand
