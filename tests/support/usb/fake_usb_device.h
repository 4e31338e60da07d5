#pragma once

#include <deque>
#include <functional>
#include <map>

#include "core/link/usb_device_model.h"
#include "core/link/usb_standard_requests.h"

namespace kickstand::testing {

/// A USB device for tests of links: it keeps what it is sent and says what it was told to say. Bulk and
/// interrupt endpoints both ways, two interfaces. As with every model, all of it on one thread.
class FakeUsbDevice final : public UsbDeviceModel {
  public:
    static constexpr std::uint16_t kVendor = 0x1209;
    static constexpr std::uint16_t kProduct = 0x0001;
    static constexpr std::uint8_t kSlowIn = 0x81;  ///< Interrupt, 4 bytes, 25 ms; interface 0.
    static constexpr std::uint8_t kBulkIn = 0x83;  ///< Bulk, 8 bytes; interface 0.
    static constexpr std::uint8_t kFastOut =
        0x05;  ///< Interrupt, 64 bytes, 1 ms; interface 1, as the next two.
    static constexpr std::uint8_t kFastIn = 0x85;   ///< Interrupt, 64 bytes, 1 ms.
    static constexpr std::uint8_t kBulkOut = 0x07;  ///< Bulk, 64 bytes.

    /// Its vendor requests, all to the device.
    static constexpr std::uint8_t kEcho = 1;    ///< IN: the bytes of the last kStore.
    static constexpr std::uint8_t kStore = 2;   ///< OUT: keeps the bytes.
    static constexpr std::uint8_t kRefuse = 3;  ///< Stalls, either way.
    static constexpr std::uint8_t kIgnore = 4;  ///< Never answers.

    struct Packet {
        std::uint8_t endpoint = 0;
        std::vector<std::uint8_t> bytes;
        friend bool operator==(const Packet&, const Packet&) = default;
    };

    FakeUsbDevice();

    void plug();
    void unplug();
    /// Offers one IN packet.
    void offer(std::uint8_t endpoint, std::vector<std::uint8_t> packet);
    /// Makes OUT endpoints answer Nak, or take packets again.
    void setBusy(bool busy);
    void halt(std::uint8_t endpoint);
    /// Every packet taken, in order.
    const std::vector<Packet>& received() const { return received_; }
    /// Every value that SET_CONFIGURATION brought, in order.
    const std::vector<std::uint8_t>& configurations() const { return configurations_; }
    /// Called after anything about the device has changed, on its thread.
    void setObserver(std::function<void()> observer) { observer_ = std::move(observer); }

    const UsbDescriptors& descriptors() const override { return descriptors_; }
    bool attached() const override { return attached_; }
    void setListener(UsbDeviceListener* listener) override { listener_ = listener; }
    UsbHandshake control(const UsbSetup& setup, ByteView out, std::vector<std::uint8_t>& in) override;
    UsbHandshake out(std::uint8_t endpoint, ByteView packet) override;
    UsbHandshake in(std::uint8_t endpoint, ByteSpan buffer, std::size_t& actual) override;

  private:
    void ready(std::uint8_t endpoint);
    void changed();

    UsbDescriptors descriptors_;
    UsbStandardRequests standard_;
    UsbDeviceListener* listener_ = nullptr;
    bool attached_ = true;
    bool busy_ = false;
    std::map<std::uint8_t, std::deque<std::vector<std::uint8_t>>> offered_;
    std::vector<Packet> received_;
    std::vector<std::uint8_t> configurations_;
    std::vector<std::uint8_t> stored_;
    std::function<void()> observer_;
};

}  // namespace kickstand::testing
