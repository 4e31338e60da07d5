#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "core/base/latch.h"
#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/usb_link.h"
#include "core/thunderbots/wire/message_packet.h"

namespace kickstand::thunderbots {

/// A message on its way to a robot.
struct OutMessage {
    int robot = 0;
    wire::Pipe pipe = wire::Pipe::TestMode;
    wire::MessagePayload payload;
    std::optional<TimePoint> expires;  ///< Dropped (KickExpired) when the dongle has not taken it by then.
};

/// The OUT half of the message pipes (protocol 3.7): messages go in the order they came, one at a time, each
/// when the dongle has a buffer free. Kicks are refused and dropped while STOP is latched. Engine thread.
class MessagePipe {
  public:
    using Done = std::function<void(Result<void>)>;

    /// Messages that may wait; one more is refused.
    static constexpr std::size_t kCapacity = 64;

    /// `failed` comes when the endpoint stalled or failed more often in a row than is tried again.
    MessagePipe(UsbLink& link, Scheduler& scheduler, const StopLatch& stop,
                std::function<void(Error)> failed);
    ~MessagePipe();
    MessagePipe(const MessagePipe&) = delete;
    MessagePipe& operator=(const MessagePipe&) = delete;

    /// Takes messages from here on, on a link that has been opened.
    void open();
    /// Ends every message with `why`.
    void close(const Error& why);

    /// Queues a message; `done` comes once, when the dongle has taken it or it was dropped. Errors, given at
    /// once: NotConnected, QueueFull, and what the encoder refuses.
    Result<void> push(const OutMessage& message, Done done);
    /// Drops every kick that the dongle has not taken yet, with this code.
    void dropKicks(Errc why);
    /// Messages that the dongle has not taken yet.
    std::size_t waiting() const { return queue_.size(); }

  private:
    struct Entry {
        OutMessage message;
        wire::MessagePacket packet;
        Done done;
        std::optional<Errc> cancelledFor;
    };

    void pump();
    void completed(std::uint64_t connection, const UsbCompletion& completion);
    void retryStalled();
    void finishFront(Result<void> result);
    void dropExpired();
    void watchExpiry();
    template <class Meant>
    void drop(Errc why, Meant meant);

    UsbLink& link_;
    Scheduler& scheduler_;
    const StopLatch& stop_;
    std::function<void(Error)> failed_;
    std::deque<Entry> queue_;  ///< The front one is on its way while inFlight_.
    UsbTransferId inFlight_ = 0;
    bool clearing_ = false;
    bool open_ = false;
    int stallsInRow_ = 0;
    std::uint64_t connection_ = 0;
    TimerId expiry_ = 0;
};

}  // namespace kickstand::thunderbots
