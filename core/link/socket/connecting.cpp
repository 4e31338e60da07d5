#include "core/link/socket/connecting.h"

#include <utility>

#include <asio/connect.hpp>
#include <asio/ip/tcp.hpp>
#ifdef __linux__
#include <netinet/tcp.h>
#include <sys/socket.h>
#endif

namespace kickstand::socket {
namespace {

#ifdef __linux__
void setOption(Protocol::socket& connected, int option, int value) {
    // One that the system does not take leaves it at its own pace.
    static_cast<void>(::setsockopt(connected.native_handle(), IPPROTO_TCP, option, &value, sizeof value));
}
#endif

}  // namespace

void setTcpOptions(Protocol::socket& connected) {
    std::error_code ignored;
    connected.set_option(asio::ip::tcp::no_delay(true), ignored);
    connected.set_option(asio::socket_base::keep_alive(true), ignored);
#ifdef __linux__
    constexpr int kIdle_s = 5;
    constexpr int kInterval_s = 1;
    constexpr int kProbes = 5;
    constexpr int kUnacknowledged_ms = 10'000;
    setOption(connected, TCP_KEEPIDLE, kIdle_s);
    setOption(connected, TCP_KEEPINTVL, kInterval_s);
    setOption(connected, TCP_KEEPCNT, kProbes);
    setOption(connected, TCP_USER_TIMEOUT, kUnacknowledged_ms);
#endif
}

Connecting::Connecting(IoCorePointer core, std::string subject, Done done)
    : core_(std::move(core)),
      subject_(std::move(subject)),
      done_(std::move(done)),
      socket_(core_->io),
      deadline_(core_->io) {}

void Connecting::connect(std::vector<Protocol::endpoint> endpoints, Duration deadline) {
    begin(deadline);
    endpoints_ = std::move(endpoints);
    tryAll();
}

void Connecting::connect(const std::string& host, std::uint16_t port, Duration deadline) {
    begin(deadline);
    lookup_ = Lookup::begin(core_, host, port, subject_,
                            [self = shared_from_this()](Result<std::vector<Protocol::endpoint>> found) {
                                if (self->ended_) return;
                                if (!found) return self->finish(fail(found.error()));
                                self->endpoints_ = std::move(*found);
                                self->tryAll();
                            });
}

void Connecting::refuse(const Error& error) {
    finish(fail(error));
}

void Connecting::begin(Duration deadline) {
    core_->tasks.insert(shared_from_this());
    deadline_.expires_after(deadline);
    deadline_.async_wait([self = shared_from_this()](const std::error_code& code) {
        if (!code) self->finish(fail(Errc::TimedOut, self->subject_));
    });
}

void Connecting::tryAll() {
    asio::async_connect(socket_, endpoints_,
                        [self = shared_from_this()](const std::error_code& code, const Protocol::endpoint&) {
                            self->connected(code);
                        });
}

void Connecting::connected(const std::error_code& code) {
    if (ended_) return;
    if (code) return finish(fail(toError(code, subject_)));
    auto connection = std::make_shared<Connection>(core_, std::move(socket_));
    connection->begin();
    finish(std::move(connection));
}

void Connecting::finish(Result<ConnectionPointer> result) {
    if (ended_) return;
    end();
    done_(std::move(result));
}

void Connecting::abandon() {
    end();
}

void Connecting::end() {
    if (std::exchange(ended_, true)) return;
    std::error_code ignored;
    if (lookup_) lookup_->abandon();
    socket_.close(ignored);
    deadline_.cancel();
    core_->tasks.erase(shared_from_this());
}

}  // namespace kickstand::socket
