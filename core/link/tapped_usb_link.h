#pragma once

#include <memory>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/tap.h"
#include "core/link/usb_link.h"

namespace kickstand {

/// Stands around a link and shows its observers everything that passes: the model is fed by this, and so is a
/// recording. Adds nothing to the link's behaviour; a completion is observed before its callback runs. Ids of
/// records are the tap's own count; clearing a halt is shown as the control transfer that it is on the wire.
class TappedUsbLink final : public UsbLink {
  public:
    /// Takes `inner` over. `scheduler` is the one that it was made with.
    TappedUsbLink(std::unique_ptr<UsbLink> inner, Scheduler& scheduler);

    /// Observers are told in the order they were added; each must outlive the link or be removed. Both may be
    /// called from inside observe(); the link itself must not be destroyed there. Link's thread.
    void addObserver(UsbTapObserver* observer);
    void removeObserver(UsbTapObserver* observer);

    void open(std::function<void(Result<UsbDeviceInfo>)> done) override;
    void close(std::function<void()> done) override;
    void control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) override;
    Result<UsbTransferId> submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) override;
    Result<UsbTransferId> submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) override;
    void cancel(UsbTransferId id) override;
    void clearHalt(std::uint8_t endpoint, UsbCallback done) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;
    UsbLinkHealth health() const override { return inner_->health(); }

  private:
    UsbCallback observedControl(const UsbSetup& setup, ByteView data, UsbCallback done);
    void observe(UsbTapRecord record);

    Scheduler& scheduler_;
    std::vector<UsbTapObserver*> observers_;
    std::function<void(bool)> presence_;
    UsbTransferId lastRecord_ = 0;
    bool open_ = false;
    bool observing_ = false;
    // Last, so that it goes first: its callbacks end here.
    std::unique_ptr<UsbLink> inner_;
};

}  // namespace kickstand
