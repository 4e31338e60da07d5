#include "core/thunderbots/in_pump.h"

#include <utility>

#include "core/thunderbots/retry.h"

namespace kickstand::thunderbots {

InPump::InPump(UsbLink& link, std::uint8_t endpoint, std::size_t packetBytes, int depth,
               std::function<void(ByteView)> received, std::function<void(Error)> failed)
    : link_(link),
      endpoint_(endpoint),
      packetBytes_(packetBytes),
      depth_(depth),
      received_(std::move(received)),
      failed_(std::move(failed)) {}

void InPump::open() {
    close();
    open_ = true;
    ask();
}

void InPump::close() {
    ++connection_;
    open_ = false;
    clearing_ = false;
    pending_ = 0;
    failuresInRow_ = 0;
}

void InPump::ask() {
    while (open_ && !clearing_ && pending_ < depth_) {
        const auto submitted = link_.submitIn(
            endpoint_, packetBytes_, [this, connection = connection_](const UsbCompletion& completion) {
                completed(connection, completion);
            });
        // Refused only while the link goes down, of which its listener is told.
        if (!submitted) return;
        ++pending_;
    }
}

void InPump::completed(std::uint64_t connection, const UsbCompletion& completion) {
    if (connection != connection_) return;
    --pending_;
    switch (completion.status) {
        case UsbStatus::Completed:
            failuresInRow_ = 0;
            if (received_) received_(completion.data);
            ask();
            return;
        case UsbStatus::Cancelled:
        case UsbStatus::NoDevice:
            return;
        case UsbStatus::Overflow:  // The model has counted it; the endpoint goes on.
        default:
            recover();
    }
}

void InPump::recover() {
    // With several transfers pending one stall ends them all: only the first of them begins the recovery.
    if (!open_ || clearing_) return;
    if (++failuresInRow_ > kStallRetries) {
        Error error;
        error.code = Errc::Stalled;
        error.endpoint = endpoint_;
        error.got = kStallRetries;
        open_ = false;
        failed_(std::move(error));
        return;
    }
    clearing_ = true;
    link_.clearHalt(endpoint_, [this, connection = connection_](const UsbCompletion&) {
        if (connection != connection_) return;
        clearing_ = false;
        ask();
    });
}

}  // namespace kickstand::thunderbots
