#pragma once

#include <cstddef>
#include <functional>

#include "core/base/bytes.h"
#include "core/base/error.h"

namespace kickstand {

/// A connection that carries bytes in order, both ways: TCP, or a local socket. Everything is called, and
/// calls back, on the thread of the scheduler that it was made with. Destroying it closes it and silences it.
class ByteStream {
  public:
    struct Events {
        /// Bytes that came in, in pieces of any size. No more are read from the system until this has
        /// returned: a peer that floods fills its own buffers.
        std::function<void(ByteView)> received;
        /// The connection has ended by the peer (Disconnected) or by an error (Io); called once, last, and
        /// not after close().
        std::function<void(const Error&)> closed;
    };

    virtual ~ByteStream() = default;

    /// Begins to read. Called once; what came before is kept.
    virtual void start(Events events) = 0;
    /// Queues bytes to be sent. Ignored once closed.
    virtual void send(ByteView bytes) = 0;
    /// Bytes queued and not yet taken by the system: what a writer bounds itself by.
    virtual std::size_t unsent() const = 0;
    /// Ends the connection after what is queued has been sent, or at once when the peer takes nothing for a
    /// second. Nothing is called back after it.
    virtual void close() = 0;
};

}  // namespace kickstand
