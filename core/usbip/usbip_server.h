#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/usbip/usbip_connection.h"
#include "core/usbip/usbip_exports.h"

namespace kickstand {

/// Where a USB/IP server listens, and how much it bears.
struct UsbipServerOptions {
    std::string address = "127.0.0.1";  ///< Numeric. Anything but a loopback address needs `anyAddress`.
    std::uint16_t port = usbip::kDefaultPort;  ///< 0 takes any free one.
    bool anyAddress = false;         ///< Whoever asks in so many words may be served to other machines.
    std::size_t maxConnections = 8;  ///< Others are closed at once, and counted.
    UsbipLimits limits{};            ///< Of one connection.
};

/// Exports simulated USB devices over USB/IP 1.1.1, to several clients one after another: a Linux kernel
/// (`usbip attach`) or the client of core/link/usbip. A device that is imported is Busy for everybody else;
/// when it is pulled out its transfers end with ESHUTDOWN and its connection is closed, as Linux's server
/// does. It is given back unconfigured when its client goes. Every method is called on the scheduler's
/// thread.
class UsbipServer {
  public:
    /// Hears what happens, as "client 3 imported 1-1".
    using Log = std::function<void(const std::string& line)>;

    /// Begins to serve. The scheduler is that of the models; both must outlive the server. Errors: those of
    /// Sockets::listenTcp() and UsbipExports::make(); BadArgument for an address that is not a loopback one
    /// without `anyAddress`.
    static Result<std::unique_ptr<UsbipServer>> serve(Scheduler& scheduler, std::vector<UsbipExport> exports,
                                                      const UsbipServerOptions& options = {}, Log log = {});
    ~UsbipServer();
    UsbipServer(const UsbipServer&) = delete;
    UsbipServer& operator=(const UsbipServer&) = delete;

    /// The port that clients find it at.
    std::uint16_t port() const;
    /// What has happened so far.
    UsbipServerReport report() const;

  private:
    class Impl;
    explicit UsbipServer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace kickstand
