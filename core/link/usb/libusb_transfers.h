#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <unordered_map>

#include "core/link/usb/libusb_support.h"

namespace kickstand::usb {

/// How libusb ended a transfer.
struct EndedTransfer {
    UsbTransferId id = 0;
    UsbStatus status = UsbStatus::Failed;
    std::vector<std::uint8_t> bytes;  ///< What came in; empty for OUT.
    std::size_t actual = 0;
};

/// What to submit. For a control transfer the setup is given and the endpoint is 0.
struct TransferRequest {
    UsbTransferId id = 0;
    std::uint8_t endpoint = 0;
    unsigned char type = LIBUSB_TRANSFER_TYPE_INTERRUPT;
    std::optional<UsbSetup> setup;
    ByteView out;          ///< What to send; empty for IN.
    std::size_t size = 0;  ///< How much to ask for, for IN.
};

/// The transfers of one open device that libusb holds: each from its submission until libusb has called it
/// back. Thread-safe.
class LibusbTransfers {
  public:
    /// `ended` hears of every transfer once, on the event thread.
    explicit LibusbTransfers(std::function<void(EndedTransfer)> ended);
    /// Only when none is left.
    ~LibusbTransfers();
    LibusbTransfers(const LibusbTransfers&) = delete;
    LibusbTransfers& operator=(const LibusbTransfers&) = delete;

    /// Hands a transfer to libusb and does not wait. Gives libusb's code; on an error nothing is heard of the
    /// transfer again.
    int submit(libusb_device_handle* handle, const TransferRequest& request);
    /// Asks libusb to end a transfer early; nothing happens where it has ended. May take a millisecond.
    void cancel(UsbTransferId id);
    /// Ends all of them and waits until none is left. Submit nothing meanwhile.
    void cancelAllAndWait();

  private:
    struct Flight;

    static void LIBUSB_CALL calledBack(libusb_transfer* transfer);
    void finish(Flight& flight);

    const std::function<void(EndedTransfer)> ended_;
    std::mutex mutex_;
    std::condition_variable emptied_;
    std::unordered_map<UsbTransferId, std::unique_ptr<Flight>> flights_;
};

}  // namespace kickstand::usb
