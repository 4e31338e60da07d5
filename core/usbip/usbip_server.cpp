#include "core/usbip/usbip_server.h"

#include <list>
#include <utility>

#include "core/link/socket/sockets.h"

namespace kickstand {
namespace {

bool isLoopback(const std::string& address) {
    return address.starts_with("127.") || address == "::1";
}

}  // namespace

class UsbipServer::Impl {
  public:
    Impl(Scheduler& scheduler, UsbipExports exports, const UsbipServerOptions& options, Log log)
        : scheduler_(scheduler),
          options_(options),
          hall_{.exports = std::move(exports), .log = std::move(log)},
          sockets_(scheduler) {}

    Result<void> listen() {
        auto listener =
            sockets_.listenTcp(options_.address, options_.port,
                               [this](std::unique_ptr<ByteStream> stream) { accept(std::move(stream)); });
        if (!listener) return fail(listener.error());
        listener_ = std::move(*listener);
        return {};
    }

    std::uint16_t port() const { return listener_->port(); }
    UsbipServerReport report() const {
        UsbipServerReport report = hall_.report;
        report.inUse = hall_.exports.anyTaken();
        return report;
    }

  private:
    void accept(std::unique_ptr<ByteStream> stream) {
        if (connections_.size() >= options_.maxConnections) {
            ++hall_.report.refused;
            if (hall_.log) hall_.log("a client was turned away: too many are here");
            return;
        }
        const auto place = connections_.emplace(connections_.end());
        *place = std::make_unique<UsbipConnection>(scheduler_, std::move(stream), hall_, options_.limits,
                                                   [this, place] { connections_.erase(place); });
    }

    Scheduler& scheduler_;
    const UsbipServerOptions options_;
    UsbipHall hall_;
    Sockets sockets_;
    std::unique_ptr<Listener> listener_;
    std::list<std::unique_ptr<UsbipConnection>> connections_;
};

Result<std::unique_ptr<UsbipServer>> UsbipServer::serve(Scheduler& scheduler,
                                                        std::vector<UsbipExport> exports,
                                                        const UsbipServerOptions& options, Log log) {
    if (!options.anyAddress && !isLoopback(options.address))
        return fail(Errc::BadArgument, "address", options.address + " can be reached from other machines");
    auto made = UsbipExports::make(exports);
    if (!made) return fail(made.error());
    auto impl = std::make_unique<Impl>(scheduler, std::move(*made), options, std::move(log));
    if (const auto listening = impl->listen(); !listening) return fail(listening.error());
    return std::unique_ptr<UsbipServer>(new UsbipServer(std::move(impl)));
}

UsbipServer::UsbipServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

UsbipServer::~UsbipServer() = default;

std::uint16_t UsbipServer::port() const {
    return impl_->port();
}

UsbipServerReport UsbipServer::report() const {
    return impl_->report();
}

}  // namespace kickstand
