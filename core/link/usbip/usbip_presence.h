#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/link/usbip/usbip_client.h"
#include "core/link/usbip/usbip_link.h"

namespace kickstand {

/// Looks twice a second whether a server has a device. On the scheduler's thread.
class UsbipPresence {
  public:
    /// `appeared` is called when the device is there and was not at the look before. It may stop or destroy
    /// this.
    UsbipPresence(Scheduler& scheduler, const UsbipAddress& address, const UsbMatch& match,
                  const UsbipConnect& connect, std::function<void()> appeared);
    ~UsbipPresence();
    UsbipPresence(const UsbipPresence&) = delete;
    UsbipPresence& operator=(const UsbipPresence&) = delete;

    /// Begins to look. `there` is what is known already: without it the first look, which comes at once,
    /// finds it out and tells nobody.
    void start(std::optional<bool> there);
    void stop();

  private:
    void look();
    void ask(std::unique_ptr<ByteStream> stream);
    void looked(bool there);
    bool isListed(const std::vector<usbip::Device>& devices) const;

    Scheduler& scheduler_;
    const UsbipAddress address_;
    const UsbMatch match_;
    const UsbipConnect connect_;
    const std::function<void()> appeared_;
    std::optional<bool> there_;
    TimerId timer_ = 0;
    std::unique_ptr<UsbipClient> client_;
    std::shared_ptr<const bool> looking_;  ///< While one is under way; what a look before it asked is void.
};

}  // namespace kickstand
