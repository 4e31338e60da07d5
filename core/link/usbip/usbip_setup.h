#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/link/usbip/usb_descriptor_reader.h"
#include "core/link/usbip/usbip_client.h"

namespace kickstand {

/// A device that is ready for transfers.
struct UsbipDevice {
    UsbDeviceInfo info;
    std::vector<UsbEndpointInfo> endpoints;  ///< Of the interfaces that are used.
};

/// What a host does with a device that it has just imported: reads its descriptors and strings, sets
/// configuration 0 and then 1. On the scheduler's thread.
class UsbipSetup {
  public:
    using Done = std::function<void(Result<UsbipDevice>)>;

    /// Begins. `done` is called once, from a callback of the client; it may destroy both. Errors: BadArgument
    /// for a device of another vendor or product, Malformed for descriptors without sense, Io where the
    /// device refuses or lacks an interface, Disconnected. `client` must outlive it; destroying it needs the
    /// client to be destroyed too.
    UsbipSetup(UsbipClient& client, const UsbMatch& match, std::string port, Done done);
    UsbipSetup(const UsbipSetup&) = delete;
    UsbipSetup& operator=(const UsbipSetup&) = delete;

  private:
    using Next = void (UsbipSetup::*)(ByteView data);

    void read(std::uint8_t type, std::uint8_t index, std::uint16_t language, std::uint16_t length, Next next);
    void readText(std::uint8_t index, Next next);
    void configure(std::uint16_t value, Next next);
    void request(const UsbSetup& setup, bool mayRefuse, const char* what, Next next);
    void finish(Result<UsbipDevice> result);

    // In their order; each takes what the one before asked for.
    void deviceRead(ByteView data);
    void headerRead(ByteView data);
    void configurationRead(ByteView data);
    void languagesRead(ByteView data);
    void manufacturerRead(ByteView data);
    void productNameRead(ByteView data);
    void unconfigured(ByteView data);
    void configured(ByteView data);

    UsbipClient& client_;
    const UsbMatch match_;
    Done done_;
    UsbipDevice device_;
    UsbDeviceFacts facts_;
    std::uint16_t language_ = 0;
};

}  // namespace kickstand
