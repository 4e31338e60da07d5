#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/link/usb_types.h"

namespace kickstand {

/// What a device answers to one token on the bus.
enum class UsbHandshake : std::uint8_t {
    Ack,
    Nak,    ///< Not now: ask again when the device says that the endpoint is ready.
    Stall,  ///< Halted, or a request it does not take.
};

/// One endpoint as the configuration descriptor has it.
struct UsbEndpointInfo {
    enum class Type : std::uint8_t { Control = 0, Isochronous = 1, Bulk = 2, Interrupt = 3 };

    std::uint8_t address = 0;
    Type type = Type::Interrupt;
    std::uint16_t packetSize = 0;
    std::uint8_t interval_ms = 0;
    std::uint8_t interface = 0;
};

/// Everything a host reads about a device when it enumerates it, in the form it travels.
struct UsbDescriptors {
    std::vector<std::uint8_t> device;             ///< 18 bytes.
    std::vector<std::uint8_t> configuration;      ///< With its interfaces and endpoints.
    std::map<std::uint8_t, std::string> strings;  ///< By index, as UTF-8.
    std::vector<UsbEndpointInfo> endpoints;       ///< The same endpoints, taken apart.
};

/// Hears from a device model. Called on the model's thread, possibly from inside a call into the model.
class UsbDeviceListener {
  public:
    virtual ~UsbDeviceListener() = default;
    /// The endpoint answered Nak before and may answer otherwise now.
    virtual void endpointReady(std::uint8_t endpoint) = 0;
    /// The device was plugged in (true) or pulled out (false).
    virtual void attachedChanged(bool attached) = 0;
};

/// A USB device in software: what a host controller finds at the other end of the cable. Implemented by the
/// simulators, served in this process (loopback), to libusb (umockdev, in tests) and to any host (USB/IP).
/// One thread, that of the scheduler it was made with. While it is not attached nothing else may be called
/// than descriptors() and attached().
class UsbDeviceModel {
  public:
    virtual ~UsbDeviceModel() = default;

    /// The same for as long as the model lives.
    virtual const UsbDescriptors& descriptors() const = 0;
    /// Whether it is plugged in.
    virtual bool attached() const = 0;
    /// At most one listener; nullptr to have none.
    virtual void setListener(UsbDeviceListener* listener) = 0;

    /// A control transfer, standard requests included. For IN, `in` is replaced by the answer (cut by the
    /// caller to setup.length). A simulator never answers Nak; a host that hears it asks again until its
    /// deadline.
    virtual UsbHandshake control(const UsbSetup& setup, ByteView out, std::vector<std::uint8_t>& in) = 0;
    /// One OUT packet, taken whole or not at all.
    virtual UsbHandshake out(std::uint8_t endpoint, ByteView packet) = 0;
    /// One IN token: on Ack the packet is in the first `actual` bytes of `buffer`, which holds the endpoint's
    /// packet size.
    virtual UsbHandshake in(std::uint8_t endpoint, ByteSpan buffer, std::size_t& actual) = 0;
};

}  // namespace kickstand
