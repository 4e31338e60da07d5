#pragma once

#include "core/link/usb/libusb_transfers.h"
#include "core/link/usb_device_model.h"

namespace kickstand::usb {

/// A device that this program has open, configured and claimed. Made, closed and destroyed on a thread that
/// may block; what is called elsewhere says so.
class LibusbDevice {
  public:
    /// Finds the one device that matches, sets configuration 0 and then 1, and claims its interfaces. Errors:
    /// NoDevice, SeveralDevices with their ports as the detail, PermissionDenied, ClaimedElsewhere,
    /// Disconnected, Io. `ended` as LibusbTransfers takes it.
    static Result<std::unique_ptr<LibusbDevice>> open(libusb_context* context, const UsbMatch& match,
                                                      std::function<void(EndedTransfer)> ended);
    /// Ends all transfers, releases the interfaces and closes the device.
    ~LibusbDevice();
    LibusbDevice(const LibusbDevice&) = delete;
    LibusbDevice& operator=(const LibusbDevice&) = delete;

    const UsbDeviceInfo& info() const { return info_; }
    const std::vector<UsbEndpointInfo>& endpoints() const { return endpoints_; }
    /// Whether `device` is this one: as long as it is open, no other has its address. Any thread.
    bool is(const libusb_device* device) const { return device_.get() == device; }
    /// Hands a transfer to libusb, and gives libusb's code. The link's thread.
    int submit(TransferRequest request);
    /// Asks for an early end. The link's thread.
    void cancel(UsbTransferId id) { transfers_.cancel(id); }
    UsbStatus clearHalt(std::uint8_t endpoint);

  private:
    LibusbDevice(DeviceRef device, Handle handle, std::function<void(EndedTransfer)> ended);
    Result<void> configure(const std::vector<std::uint8_t>& interfaces);
    Result<void> readEndpoints();

    DeviceRef device_;
    Handle handle_;
    LibusbTransfers transfers_;
    std::vector<std::uint8_t> claimed_;
    std::vector<UsbEndpointInfo> endpoints_;
    UsbDeviceInfo info_;
};

}  // namespace kickstand::usb
