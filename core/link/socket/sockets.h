#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/socket/byte_stream.h"

namespace kickstand {

/// The end of a listening: destroying it closes the port (or removes the local socket's file). Streams that
/// it accepted live on.
class Listener {
  public:
    virtual ~Listener() = default;
    /// The port that was given out where 0 was asked for; 0 for a local socket. Any thread.
    virtual std::uint16_t port() const = 0;
};

/// The connections of one program or link: owns the thread on which the operating system is waited for.
/// Destroying it ends them all at once and silences them; streams and listeners that are left take nothing
/// any more. Everything is made, called and destroyed on the scheduler's thread (or after that has ended),
/// and every callback comes there, never from inside the call.
class Sockets {
  public:
    /// `scheduler` must outlive this.
    explicit Sockets(Scheduler& scheduler);
    ~Sockets();
    Sockets(const Sockets&) = delete;
    Sockets& operator=(const Sockets&) = delete;

    using Connected = std::function<void(Result<std::unique_ptr<ByteStream>>)>;
    using Accepted = std::function<void(std::unique_ptr<ByteStream>)>;

    /// Connects over TCP, without Nagle's delay. `host` is a name or an address. A peer that is gone without
    /// a word is noticed within some ten seconds. Errors: NoDevice when nobody listens there or the name is
    /// unknown, TimedOut after `deadline`, PermissionDenied, Io; with the system's word in `detail`.
    void connectTcp(const std::string& host, std::uint16_t port, Duration deadline, Connected done);
    /// Connects to a local socket of this machine. Errors as connectTcp(); BadArgument and OutOfRange for a
    /// path that no local socket has.
    void connectLocal(const std::string& path, Duration deadline, Connected done);

    /// Listens at a numeric address; port 0 takes any free one. Errors: ClaimedElsewhere for a port that is
    /// in use, PermissionDenied, BadArgument for an address that is none, Io.
    Result<std::unique_ptr<Listener>> listenTcp(const std::string& address, std::uint16_t port,
                                                Accepted accepted);
    /// Listens on a local socket that only this user may open. A file that a dead program left is replaced;
    /// one that somebody answers on, or that is no socket, is ClaimedElsewhere. Errors as listenTcp(),
    /// OutOfRange for a path too long.
    Result<std::unique_ptr<Listener>> listenLocal(const std::string& path, Accepted accepted);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace kickstand
