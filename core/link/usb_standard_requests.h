#pragma once

#include <functional>
#include <optional>
#include <set>

#include "core/link/usb_device_model.h"

namespace kickstand {

/// Answers the standard requests of USB 2.0, 9.4 for a device model, so that any host finds in it what it
/// expects of a device: a kernel through USB/IP, libusb, or the loopback. Keeps the configuration and the
/// halted endpoints. Not thread-safe: on the model's thread.
class UsbStandardRequests {
  public:
    /// What the model wants to hear of; either may be empty.
    struct Hooks {
        /// SET_CONFIGURATION was accepted, be it the same value again: the model starts afresh.
        std::function<void(std::uint8_t configuration)> configured;
        /// The host cleared this endpoint's halt: the model has something to say on it again.
        std::function<void(std::uint8_t endpoint)> haltCleared;
    };

    /// `descriptors` must outlive this.
    explicit UsbStandardRequests(const UsbDescriptors& descriptors, Hooks hooks = {});

    /// Answers a standard request; one that is not supported stalls. Empty for class and vendor requests,
    /// which are the model's own. The answer in `in` is whole: the caller cuts it to setup.length.
    std::optional<UsbHandshake> handle(const UsbSetup& setup, std::vector<std::uint8_t>& in);

    /// 0 until the host has chosen configuration 1, and after it chose 0.
    std::uint8_t configuration() const { return configuration_; }
    /// Whether the model has to answer Stall on this endpoint.
    bool isHalted(std::uint8_t endpoint) const { return halted_.contains(endpoint); }
    /// Halts an endpoint until the host clears it or configures the device.
    void halt(std::uint8_t endpoint) { halted_.insert(endpoint); }
    /// As after power-up or a bus reset: not configured, nothing halted. Calls no hook.
    void reset();

  private:
    bool device(const UsbSetup& setup, std::vector<std::uint8_t>& in);
    bool interface(const UsbSetup& setup, std::vector<std::uint8_t>& in);
    bool endpoint(const UsbSetup& setup, std::vector<std::uint8_t>& in);
    bool descriptor(const UsbSetup& setup, std::vector<std::uint8_t>& in) const;
    bool setConfiguration(std::uint16_t value);
    bool hasEndpoint(std::uint16_t index) const;
    bool hasInterface(std::uint16_t index) const;

    const UsbDescriptors& descriptors_;
    Hooks hooks_;
    std::uint8_t configuration_ = 0;
    std::set<std::uint8_t> halted_;
};

}  // namespace kickstand
