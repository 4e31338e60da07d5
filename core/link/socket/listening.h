#pragma once

#include <functional>
#include <memory>
#include <string>

#include <asio/basic_socket_acceptor.hpp>
#include <asio/steady_timer.hpp>

#include "core/base/result.h"
#include "core/link/socket/connection.h"

namespace kickstand::socket {

using Acceptor = asio::basic_socket_acceptor<Protocol>;

/// What accepts connections, one after the other: the next one waits in the system until the last has been
/// taken.
class Listening final : public IoTask, public std::enable_shared_from_this<Listening> {
  public:
    /// Where connections go, on the scheduler's thread; gone with the Listener.
    using Taker = std::function<void(ConnectionPointer)>;

    Listening(IoCorePointer core, Acceptor acceptor, std::weak_ptr<Taker> taker);

    /// The sockets' thread, as all of it but the making.
    void begin();
    void abandon() override;

  private:
    void accept();
    void accepted(const std::error_code& code, Protocol::socket peer);
    /// The scheduler's thread.
    void deliver(const ConnectionPointer& connection);

    const IoCorePointer core_;
    const std::weak_ptr<Taker> taker_;
    Acceptor acceptor_;
    asio::steady_timer retry_;
    bool ended_ = false;
};

/// An acceptor that listens at `endpoint`, from any thread. `prepare` runs between the binding and the
/// listening: nobody can connect before it. Errors as toError() has them.
Result<Acceptor> listenAt(asio::io_context& io, const Protocol::endpoint& endpoint,
                          const std::string& subject, const std::function<std::error_code()>& prepare = {});

/// listenAt() for the local socket at `path`: readable and writable for its owner alone, in the place of one
/// that nobody serves any more. Errors: OutOfRange for a path too long, ClaimedElsewhere where somebody
/// answers or something else than a socket stands there.
Result<Acceptor> listenLocally(asio::io_context& io, const std::string& path);

}  // namespace kickstand::socket
