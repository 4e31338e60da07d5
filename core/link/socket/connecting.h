#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/steady_timer.hpp>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/link/socket/connection.h"
#include "core/link/socket/lookup.h"

namespace kickstand::socket {

/// One attempt to connect, from the look-up of the name to the connection or the deadline. Made on the
/// scheduler's thread, then the sockets' thread alone.
class Connecting final : public IoTask, public std::enable_shared_from_this<Connecting> {
  public:
    using Done = std::function<void(Result<ConnectionPointer>)>;

    /// `done` is called once on the sockets' thread, unless abandoned. `subject` is what errors name.
    Connecting(IoCorePointer core, std::string subject, Done done);

    void connect(std::vector<Protocol::endpoint> endpoints, Duration deadline);
    /// As connect(), for a name that has to be looked up.
    void connect(const std::string& host, std::uint16_t port, Duration deadline);
    /// Ends it with an error that was known before.
    void refuse(const Error& error);
    void abandon() override;

  private:
    void begin(Duration deadline);
    void tryAll();
    void connected(const std::error_code& code);
    void finish(Result<ConnectionPointer> result);
    void end();

    const IoCorePointer core_;
    const std::string subject_;
    Done done_;
    std::vector<Protocol::endpoint> endpoints_;
    std::shared_ptr<Lookup> lookup_;
    Protocol::socket socket_;
    asio::steady_timer deadline_;
    bool ended_ = false;
};

/// The sockets' thread: what every TCP connection is set to. No delay for small packets; a peer that is gone
/// without a word is noticed within some ten seconds, in silence too.
void setTcpOptions(Protocol::socket& connected);

}  // namespace kickstand::socket
