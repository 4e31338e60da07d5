#include "core/thunderbots/message_pipe.h"

#include <algorithm>
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

MessagePipe::~MessagePipe() {
    scheduler_.cancel(expiry_);
}

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
    watchExpiry();
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
    }
}

void MessagePipe::watchExpiry() {
    scheduler_.cancel(std::exchange(expiry_, 0));
    std::optional<TimePoint> next;
    for (const Entry& entry : queue_) {
        if (!entry.message.expires || entry.cancelledFor) continue;
        next = next ? std::min(*next, *entry.message.expires) : *entry.message.expires;
    }
    if (next) expiry_ = scheduler_.callAt(*next, [this] { dropExpired(); });
}

void MessagePipe::dropExpired() {
    expiry_ = 0;
    const TimePoint now = scheduler_.now();
    drop(Errc::KickExpired,
         [now](const OutMessage& message) { return message.expires && now >= *message.expires; });
    watchExpiry();
}

void MessagePipe::dropKicks(Errc why) {
    drop(why, [](const OutMessage& message) { return message.pipe == wire::Pipe::Kick; });
}

template <class Meant>
void MessagePipe::drop(Errc why, Meant meant) {
    std::deque<Entry> kept;
    std::deque<Entry> dropped;
    for (Entry& entry : queue_) {
        const bool onItsWay = inFlight_ != 0 && &entry == &queue_.front();
        if (onItsWay && meant(entry.message) && !entry.cancelledFor) {
            // It may have gone already: how it ended is told when the transfer ends.
            entry.cancelledFor = why;
            link_.cancel(inFlight_);
        }
        (meant(entry.message) && !onItsWay ? dropped : kept).push_back(std::move(entry));
    }
    queue_.swap(kept);
    for (Entry& entry : dropped)
        entry.done(fail(droppedError(entry.message, why)));
}

void MessagePipe::finishFront(Result<void> result) {
    const Entry entry = std::move(queue_.front());
    queue_.pop_front();
    watchExpiry();
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
