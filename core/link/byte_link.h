#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace kickstand {

/// Bits per second of a serial line. Eight data bits, no parity, one stop bit is all that is ever used here.
using Baud = std::uint32_t;

/// How a serial line was opened.
struct ByteLinkInfo {
    std::string port;         ///< "/dev/ttyACM0"; for a simulated device a name of its own.
    std::string description;  ///< What the system knows of it: "Arduino Micro". May be empty.
    Baud baud = 0;

    friend bool operator==(const ByteLinkInfo&, const ByteLinkInfo&) = default;
};

/// A stream of bytes in both directions, as a host program uses it: a serial port, or a simulated device in
/// this process. It has no frames: what was written in one piece may arrive in several, and the other way
/// round. One contract suite (tests/contract) holds for all of them.
///
/// Every method is called on the scheduler's thread that the link was made with, and every callback comes
/// there, never from inside the call that asked for it. What may block happens on a thread of the link's own.
/// Destroying the link silences it.
class ByteLink {
  public:
    /// What may wait to be sent, in bytes.
    static constexpr std::size_t kSendLimit = 65536;

    virtual ~ByteLink() = default;

    /// Opens the line. Errors: NoDevice, PermissionDenied, ClaimedElsewhere, Io; Disconnected when it
    /// vanished meanwhile, Cancelled when close() came meanwhile, BadArgument when the link is not closed. A
    /// link that is closed or lost may be opened again.
    virtual void open(std::function<void(Result<ByteLinkInfo>)> done) = 0;

    /// Sends what waits, for 200 ms at most, and closes the line; `done` comes when nobody holds it any
    /// longer. On a link that is not open, `done` comes at once.
    virtual void close(std::function<void()> done) = 0;

    /// Queues bytes to be sent, in order; they are copied. All or nothing. Errors: NotConnected; QueueFull
    /// where more than kSendLimit bytes would wait.
    virtual Result<void> write(ByteView bytes) = 0;

    /// Bytes that were written and that the operating system has not yet taken.
    virtual std::size_t waiting() const = 0;

    /// Changes the speed of the open line; from then on for later openings as well. Errors, by `done`:
    /// NotConnected, OutOfRange, Io; Cancelled when the line went meanwhile.
    virtual void setBaud(Baud baud, std::function<void(Result<void>)> done) = 0;

    /// Takes what arrives; the bytes are valid during the call. One receiver. What arrives while there is
    /// none is dropped.
    virtual void setReceiver(std::function<void(ByteView)> receiver) = 0;

    /// Tells when the line can be opened again after it was lost (true), or the opened one is gone (false):
    /// pulled out, hung up, or refused to go on. With the latter the link counts as closed and what waited is
    /// dropped. One listener.
    virtual void setPresenceListener(std::function<void(bool present)> listener) = 0;
};

}  // namespace kickstand
