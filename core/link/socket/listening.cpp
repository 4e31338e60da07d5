#include "core/link/socket/listening.h"

#include <cerrno>
#include <filesystem>
#include <utility>

#include <asio/error.hpp>
#include <asio/local/stream_protocol.hpp>

#include "core/link/socket/connecting.h"
#include "core/link/socket/local_path.h"

namespace kickstand::socket {
namespace {

/// After a failure to accept, which is the want of something, such as file descriptors.
constexpr auto kRetry = std::chrono::milliseconds(100);

/// Whether somebody serves the local socket. Never waits: a full queue of connections is an answer too.
bool isServed(asio::io_context& io, const Protocol::endpoint& endpoint) {
    Protocol::socket probe(io);
    std::error_code code;
    probe.open(endpoint.protocol(), code);
    if (!code) probe.non_blocking(true, code);
    if (!code) probe.connect(endpoint, code);
    return code != asio::error::connection_refused && code.value() != ENOENT;
}

}  // namespace

Listening::Listening(IoCorePointer core, Acceptor acceptor, std::weak_ptr<Taker> taker)
    : core_(std::move(core)), taker_(std::move(taker)), acceptor_(std::move(acceptor)), retry_(core_->io) {}

void Listening::begin() {
    core_->tasks.insert(shared_from_this());
    accept();
}

void Listening::abandon() {
    if (std::exchange(ended_, true)) return;
    std::error_code ignored;
    acceptor_.close(ignored);
    retry_.cancel();
    core_->tasks.erase(shared_from_this());
}

void Listening::accept() {
    if (ended_) return;
    acceptor_.async_accept([self = shared_from_this()](const std::error_code& code, Protocol::socket peer) {
        self->accepted(code, std::move(peer));
    });
}

void Listening::accepted(const std::error_code& code, Protocol::socket peer) {
    if (ended_) return;
    if (code) {
        retry_.expires_after(kRetry);
        return retry_.async_wait([self = shared_from_this()](const std::error_code&) { self->accept(); });
    }
    setTcpOptions(peer);
    auto connection = std::make_shared<Connection>(core_, std::move(peer));
    connection->begin();
    core_->mailbox.post(
        [self = shared_from_this(), connection = std::move(connection)] { self->deliver(connection); });
}

void Listening::deliver(const ConnectionPointer& connection) {
    const auto taker = taker_.lock();
    if (!taker) return connection->close();
    (*taker)(connection);
    if (!taker_.expired()) core_->post([self = shared_from_this()] { self->accept(); });
}

Result<Acceptor> listenAt(asio::io_context& io, const Protocol::endpoint& endpoint,
                          const std::string& subject, const std::function<std::error_code()>& prepare) {
    Acceptor acceptor(io);
    std::error_code code;
    acceptor.open(endpoint.protocol(), code);
    if (!code) acceptor.set_option(asio::socket_base::reuse_address(true), code);
    if (!code) acceptor.bind(endpoint, code);
    if (!code && prepare) code = prepare();
    if (!code) acceptor.listen(asio::socket_base::max_listen_connections, code);
    if (code) return fail(toError(code, subject));
    return acceptor;
}

Result<Acceptor> listenLocally(asio::io_context& io, const std::string& path) {
    if (const auto allowed = checkLocalPath(path); !allowed) return fail(allowed.error());
    namespace fs = std::filesystem;
    const Protocol::endpoint endpoint(asio::local::stream_protocol::endpoint{path});
    const auto forOwner = [&path] {
        std::error_code code;
        fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write, code);
        return code;
    };
    auto acceptor = listenAt(io, endpoint, path, forOwner);
    if (acceptor || acceptor.error().code != Errc::ClaimedElsewhere) return acceptor;
    std::error_code code;
    if (!fs::is_socket(fs::symlink_status(path, code)))
        return fail(Errc::ClaimedElsewhere, path, "this file is not a socket");
    if (isServed(io, endpoint)) return acceptor;
    fs::remove(path, code);
    return listenAt(io, endpoint, path, forOwner);
}

}  // namespace kickstand::socket
