#include "core/thunderbots/message_pipe.h"

#include <utility>

#include "core/thunderbots/retry.h"
#include "core/thunderbots/wire/dongle.h"

namespace kickstand::thunderbots {
namespace {

constexpr std::uint8_t kEndpoint = wire::address(wire::Endpoint::MessageOut);

Error droppedError(const OutMessage& message, Errc why) {
    Error error;
    error.code = why;
    error.subject = wire::name(message.pipe);
    error.robot = message.robot;
    return error;
}

}  // namespace

MessagePipe::MessagePipe(UsbLink& link, Scheduler& scheduler, const StopLatch& stop,
                         std::function<void(Error)> failed)
    : link_(link), scheduler_(scheduler), stop_(stop), failed_(std::move(failed)) {}

void MessagePipe::open() {
    open_ = true;
}

void MessagePipe::close(const Error& why) {
    ++connection_;
    open_ = false;
    inFlight_ = 0;
    clearing_ = false;
    stallsInRow_ = 0;
    scheduler_.cancel(std::exchange(expiry_, 0));
    std::deque<Entry> dropped;
    dropped.swap(queue_);
    for (Entry& entry : dropped)
        entry.done(fail(why));
}

Result<void> MessagePipe::push(const OutMessage& message, Done done) {
    if (!open_) return fail(Errc::NotConnected);
    if (queue_.size() >= kCapacity) {
        Error error = droppedError(message, Errc::QueueFull);
        error.highest = static_cast<std::int64_t>(kCapacity);
        return fail(std::move(error));
    }
    const auto packet = wire::encodeMessagePacket(static_cast<std::uint8_t>(message.robot), message.pipe,
                                                  message.payload.view());
    if (!packet) return fail(wire::toError(packet.error(), "message"));
    queue_.push_back({message, *packet, std::move(done), std::nullopt});
    pump();
    return {};
}

void MessagePipe::pump() {
    while (open_ && inFlight_ == 0 && !clearing_ && !queue_.empty()) {
        const Entry& front = queue_.front();
        if (front.message.pipe == wire::Pipe::Kick && stop_.isSet()) {
            finishFront(fail(droppedError(front.message, Errc::StopLatched)));
            continue;
        }
        if (front.message.expires && scheduler_.now() >= *front.message.expires) {
            finishFront(fail(droppedError(front.message, Errc::KickExpired)));
            continue;
        }
        const auto submitted =
            link_.submitOut(kEndpoint, front.packet.view(),
                            [this, connection = connection_](const UsbCompletion& completion) {
                                completed(connection, completion);
                            });
        if (!submitted) {
            finishFront(fail(submitted.error()));
            continue;
        }
        inFlight_ = *submitted;
        watchFront();
    }
}

void MessagePipe::watchFront() {
    scheduler_.cancel(std::exchange(expiry_, 0));
    if (const auto expires = queue_.front().message.expires)
        expiry_ = scheduler_.callAt(*expires, [this] { cancelFront(Errc::KickExpired); });
}

void MessagePipe::cancelFront(Errc why) {
    if (inFlight_ == 0 || queue_.empty()) return;
    queue_.front().cancelledFor = why;
    link_.cancel(inFlight_);
}

void MessagePipe::dropKicks(Errc why) {
    std::deque<Entry> kept;
    std::deque<Entry> dropped;
    const bool frontOnItsWay = inFlight_ != 0 || clearing_;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
        Entry& entry = queue_[i];
        const bool keep = entry.message.pipe != wire::Pipe::Kick || (i == 0 && frontOnItsWay);
        (keep ? kept : dropped).push_back(std::move(entry));
    }
    queue_.swap(kept);
    if (frontOnItsWay && !queue_.empty() && queue_.front().message.pipe == wire::Pipe::Kick) cancelFront(why);
    for (Entry& entry : dropped)
        entry.done(fail(droppedError(entry.message, why)));
}

void MessagePipe::finishFront(Result<void> result) {
    scheduler_.cancel(std::exchange(expiry_, 0));
    const Entry entry = std::move(queue_.front());
    queue_.pop_front();
    entry.done(std::move(result));
}

void MessagePipe::completed(std::uint64_t connection, const UsbCompletion& completion) {
    if (connection != connection_) return;
    inFlight_ = 0;
    switch (completion.status) {
        case UsbStatus::Completed:
            // A cancel that came too late changes nothing: the dongle has it.
            stallsInRow_ = 0;
            finishFront({});
            break;
        case UsbStatus::Stalled:
            if (queue_.front().cancelledFor) {
                finishFront(fail(droppedError(queue_.front().message, *queue_.front().cancelledFor)));
                break;
            }
            retryStalled();
            return;
        case UsbStatus::NoDevice:
            finishFront(fail(droppedError(queue_.front().message, Errc::Disconnected)));
            break;
        default: {
            const Entry& front = queue_.front();
            finishFront(fail(droppedError(front.message, front.cancelledFor.value_or(Errc::Io))));
        }
    }
    pump();
}

void MessagePipe::retryStalled() {
    if (++stallsInRow_ > kStallRetries) {
        Error error;
        error.code = Errc::Stalled;
        error.endpoint = kEndpoint;
        error.got = kStallRetries;
        failed_(std::move(error));
        return;
    }
    // A stalled packet was not taken, so that sending it again cannot deliver it twice.
    clearing_ = true;
    link_.clearHalt(kEndpoint, [this, connection = connection_](const UsbCompletion&) {
        if (connection != connection_) return;
        clearing_ = false;
        pump();
    });
}

}  // namespace kickstand::thunderbots
