#include "core/link/socket/sockets.h"

#include <filesystem>
#include <list>
#include <thread>
#include <utility>

#include <asio/ip/tcp.hpp>

#include "core/link/socket/connecting.h"
#include "core/link/socket/listening.h"
#include "core/link/socket/local_path.h"

namespace kickstand {
namespace {

using socket::Acceptor;
using socket::Connecting;
using socket::ConnectionPointer;
using socket::IoCore;
using socket::IoCorePointer;
using socket::Listening;
using socket::Protocol;

class SocketListener final : public Listener {
  public:
    SocketListener(IoCorePointer core, Acceptor acceptor, Sockets::Accepted accepted, std::uint16_t port,
                   std::string path)
        : core_(std::move(core)),
          port_(port),
          path_(std::move(path)),
          taker_(std::make_shared<Listening::Taker>(
              [accepted = std::move(accepted)](ConnectionPointer connection) {
                  accepted(socket::makeStream(std::move(connection)));
              })),
          listening_(std::make_shared<Listening>(core_, std::move(acceptor), taker_)) {
        core_->post([listening = listening_] { listening->begin(); });
    }
    ~SocketListener() override {
        taker_.reset();
        core_->post([listening = std::move(listening_)] { listening->abandon(); });
        std::error_code ignored;
        if (!path_.empty()) std::filesystem::remove(path_, ignored);
    }
    SocketListener(const SocketListener&) = delete;
    SocketListener& operator=(const SocketListener&) = delete;

    std::uint16_t port() const override { return port_; }

  private:
    const IoCorePointer core_;
    const std::uint16_t port_;
    const std::string path_;
    std::shared_ptr<Listening::Taker> taker_;
    std::shared_ptr<Listening> listening_;
};

/// Of an acceptor at a TCP endpoint.
std::uint16_t portOf(const Acceptor& acceptor) {
    std::error_code ignored;
    const Protocol::endpoint local = acceptor.local_endpoint(ignored);
    asio::ip::tcp::endpoint endpoint;
    if (local.size() > endpoint.capacity()) return 0;
    endpoint.resize(local.size());
    std::copy_n(reinterpret_cast<const std::uint8_t*>(local.data()), local.size(),
                reinterpret_cast<std::uint8_t*>(endpoint.data()));
    return endpoint.port();
}

}  // namespace

class Sockets::Impl {
  public:
    explicit Impl(Scheduler& scheduler)
        : core_(std::make_shared<IoCore>(scheduler)),
          work_(asio::make_work_guard(core_->io)),
          thread_([core = core_] { core->io.run(); }) {}
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void connectTcp(const std::string& host, std::uint16_t port, Duration deadline, Connected done);
    void connectLocal(const std::string& path, Duration deadline, Connected done);
    const IoCorePointer& core() const { return core_; }

  private:
    std::shared_ptr<Connecting> connecting(std::string subject, Connected done);

    const IoCorePointer core_;
    asio::executor_work_guard<asio::io_context::executor_type> work_;
    std::thread thread_;
    /// Who waits for a connection: here, so that what they hold never leaves the scheduler's thread.
    std::list<std::shared_ptr<Connected>> waiting_;
};

Sockets::Impl::~Impl() {
    core_->mailbox.close();
    core_->post([core = core_] {
        while (!core->tasks.empty()) {
            const auto task = *core->tasks.begin();
            task->abandon();
        }
    });
    core_->over = true;
    work_.reset();
    thread_.join();
}

std::shared_ptr<Connecting> Sockets::Impl::connecting(std::string subject, Connected done) {
    const auto& kept = waiting_.emplace_back(std::make_shared<Connected>(std::move(done)));
    return std::make_shared<Connecting>(
        core_, std::move(subject),
        [this, core = core_, observed = std::weak_ptr(kept)](Result<ConnectionPointer> result) {
            core->mailbox.post([this, observed, result = std::move(result)] {
                const auto waiter = observed.lock();
                if (!waiter) return;
                waiting_.remove(waiter);
                if (!result) return (*waiter)(fail(result.error()));
                (*waiter)(socket::makeStream(*result));
            });
        });
}

void Sockets::Impl::connectTcp(const std::string& host, std::uint16_t port, Duration deadline,
                               Connected done) {
    auto attempt = connecting(host + ":" + std::to_string(port), std::move(done));
    std::error_code unknown;
    const auto address = asio::ip::make_address(host, unknown);
    if (!unknown) {
        core_->post([attempt = std::move(attempt), endpoint = asio::ip::tcp::endpoint(address, port),
                     deadline] { attempt->connect({Protocol::endpoint(endpoint)}, deadline); });
        return;
    }
    core_->post(
        [attempt = std::move(attempt), host, port, deadline] { attempt->connect(host, port, deadline); });
}

void Sockets::Impl::connectLocal(const std::string& path, Duration deadline, Connected done) {
    auto attempt = connecting(path, std::move(done));
    if (auto allowed = socket::checkLocalPath(path); !allowed) {
        core_->post(
            [attempt = std::move(attempt), error = std::move(allowed.error())] { attempt->refuse(error); });
        return;
    }
    core_->post([attempt = std::move(attempt), path, deadline] {
        attempt->connect({Protocol::endpoint(asio::local::stream_protocol::endpoint{path})}, deadline);
    });
}

Sockets::Sockets(Scheduler& scheduler) : impl_(std::make_unique<Impl>(scheduler)) {}

Sockets::~Sockets() = default;

void Sockets::connectTcp(const std::string& host, std::uint16_t port, Duration deadline, Connected done) {
    impl_->connectTcp(host, port, deadline, std::move(done));
}

void Sockets::connectLocal(const std::string& path, Duration deadline, Connected done) {
    impl_->connectLocal(path, deadline, std::move(done));
}

Result<std::unique_ptr<Listener>> Sockets::listenTcp(const std::string& address, std::uint16_t port,
                                                     Accepted accepted) {
    std::error_code unknown;
    const auto numeric = asio::ip::make_address(address, unknown);
    if (unknown) return fail(Errc::BadArgument, address, unknown.message());
    const asio::ip::tcp::endpoint endpoint(numeric, port);
    auto acceptor = socket::listenAt(impl_->core()->io, Protocol::endpoint(endpoint),
                                     address + ":" + std::to_string(port));
    if (!acceptor) return fail(std::move(acceptor.error()));
    const std::uint16_t given = portOf(*acceptor);
    return std::make_unique<SocketListener>(impl_->core(), std::move(*acceptor), std::move(accepted), given,
                                            std::string());
}

Result<std::unique_ptr<Listener>> Sockets::listenLocal(const std::string& path, Accepted accepted) {
    auto acceptor = socket::listenLocally(impl_->core()->io, path);
    if (!acceptor) return fail(std::move(acceptor.error()));
    return std::make_unique<SocketListener>(impl_->core(), std::move(*acceptor), std::move(accepted),
                                            std::uint16_t{0}, path);
}

}  // namespace kickstand
