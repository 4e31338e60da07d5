#include "core/link/usb/libusb_transfers.h"

#include <algorithm>

namespace kickstand::usb {
namespace {

struct TransferFree {
    void operator()(libusb_transfer* transfer) const { libusb_free_transfer(transfer); }
};

UsbStatus statusOf(libusb_transfer_status status) {
    switch (status) {
        case LIBUSB_TRANSFER_COMPLETED:
            return UsbStatus::Completed;
        case LIBUSB_TRANSFER_TIMED_OUT:
            return UsbStatus::TimedOut;
        case LIBUSB_TRANSFER_CANCELLED:
            return UsbStatus::Cancelled;
        case LIBUSB_TRANSFER_STALL:
            return UsbStatus::Stalled;
        case LIBUSB_TRANSFER_NO_DEVICE:
            return UsbStatus::NoDevice;
        case LIBUSB_TRANSFER_OVERFLOW:
            return UsbStatus::Overflow;
        case LIBUSB_TRANSFER_ERROR:
            break;
    }
    return UsbStatus::Failed;
}

}  // namespace

/// One transfer in libusb's hands, with the memory that it reads or writes.
struct LibusbTransfers::Flight {
    LibusbTransfers* owner = nullptr;
    UsbTransferId id = 0;
    bool isIn = false;
    std::size_t headerSize = 0;  ///< Bytes before the data: a control transfer's setup.
    std::vector<std::uint8_t> buffer;
    std::unique_ptr<libusb_transfer, TransferFree> transfer{libusb_alloc_transfer(0)};
};

LibusbTransfers::LibusbTransfers(std::function<void(EndedTransfer)> ended) : ended_(std::move(ended)) {}

LibusbTransfers::~LibusbTransfers() = default;

int LibusbTransfers::submit(libusb_device_handle* handle, const TransferRequest& request) {
    auto flight = std::make_unique<Flight>();
    libusb_transfer* transfer = flight->transfer.get();
    if (transfer == nullptr) return LIBUSB_ERROR_NO_MEM;
    flight->owner = this;
    flight->id = request.id;
    flight->isIn = request.setup ? request.setup->isIn() : isInEndpoint(request.endpoint);
    flight->headerSize = request.setup ? LIBUSB_CONTROL_SETUP_SIZE : 0;
    auto& buffer = flight->buffer;
    buffer.resize(flight->headerSize + (flight->isIn ? request.size : request.out.size()));
    if (request.setup) {
        const UsbSetup& setup = *request.setup;
        libusb_fill_control_setup(buffer.data(), setup.requestType, setup.request, setup.value, setup.index,
                                  setup.length);
    }
    if (!flight->isIn)
        std::copy(request.out.begin(), request.out.end(),
                  buffer.begin() + static_cast<std::ptrdiff_t>(flight->headerSize));
    transfer->dev_handle = handle;
    transfer->endpoint = request.endpoint;
    transfer->type = request.setup ? static_cast<unsigned char>(LIBUSB_TRANSFER_TYPE_CONTROL) : request.type;
    transfer->buffer = buffer.data();
    transfer->length = static_cast<int>(buffer.size());
    transfer->user_data = flight.get();
    transfer->callback = &LibusbTransfers::calledBack;

    // Under the lock, so that a callback that is already there finds the flight listed.
    const std::lock_guard lock(mutex_);
    const int result = libusb_submit_transfer(transfer);
    if (result == LIBUSB_SUCCESS) flights_.emplace(request.id, std::move(flight));
    return result;
}

void LibusbTransfers::cancel(UsbTransferId id) {
    // Under the lock, so that the transfer is not freed meanwhile.
    const std::lock_guard lock(mutex_);
    if (const auto found = flights_.find(id); found != flights_.end())
        libusb_cancel_transfer(found->second->transfer.get());
}

void LibusbTransfers::cancelAllAndWait() {
    std::unique_lock lock(mutex_);
    for (const auto& [id, flight] : flights_)
        libusb_cancel_transfer(flight->transfer.get());
    emptied_.wait(lock, [this] { return flights_.empty(); });
}

void LibusbTransfers::calledBack(libusb_transfer* transfer) {
    auto& flight = *static_cast<Flight*>(transfer->user_data);
    flight.owner->finish(flight);
}

void LibusbTransfers::finish(Flight& flight) {
    EndedTransfer ended;
    ended.id = flight.id;
    ended.status = statusOf(flight.transfer->status);
    ended.actual = static_cast<std::size_t>(std::max(flight.transfer->actual_length, 0));
    if (flight.isIn) {
        const std::size_t end = std::min(flight.headerSize + ended.actual, flight.buffer.size());
        ended.bytes.assign(flight.buffer.begin() + static_cast<std::ptrdiff_t>(flight.headerSize),
                           flight.buffer.begin() + static_cast<std::ptrdiff_t>(end));
    }
    // Told before it is struck off: whoever waits for the list to be empty has then heard of everything.
    ended_(std::move(ended));
    const std::lock_guard lock(mutex_);
    flights_.erase(flight.id);
    if (flights_.empty()) emptied_.notify_all();
}

}  // namespace kickstand::usb
