#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"

namespace kickstand {

/// Where a USB/IP server listens, and how much it bears.
struct UsbipServerOptions {
    std::string address = "127.0.0.1";  ///< Numeric. Anything but a loopback address needs `anyAddress`.
    std::uint16_t port = 3240;          ///< 0 takes any free one.
    bool anyAddress = false;            ///< Whoever asks in so many words may be served to other machines.
    std::size_t maxConnections = 8;     ///< Others are closed at once, and counted.
    std::size_t maxTransfers = 256;     ///< Waiting at once on a connection; one more ends it.
};

/// A device under the name that clients ask for.
struct UsbipExport {
    std::string busId;  ///< "1-1".
    UsbDeviceModel* model = nullptr;
};

/// What a server has seen, for people and tests.
struct UsbipServerReport {
    std::uint64_t connections = 0;
    std::uint64_t refused = 0;    ///< Connections that were one too many.
    std::uint64_t malformed = 0;  ///< Connections ended because no sense could be made of them.
    std::uint64_t imports = 0;
    std::uint64_t transfers = 0;
    std::uint64_t unlinked = 0;
    bool inUse = false;  ///< Somebody has imported a device at this moment.
};

/// Exports simulated USB devices over USB/IP 1.1.1, to several clients one after another: a Linux kernel
/// (`usbip attach`) or the client of core/link/usbip. A device that is imported is Busy for everybody else;
/// when it is pulled out its transfers end with ESHUTDOWN and its connection is closed, as Linux's server
/// does. It is given back unconfigured when its client goes. Every method is called on the scheduler's
/// thread.
class UsbipServer {
  public:
    /// Hears, in words of facts, what happens: a client came, imported, left, was refused.
    using Log = std::function<void(const std::string& line)>;

    /// Begins to serve. The scheduler is that of the models; both must outlive the server. Errors: those of
    /// Sockets::listenTcp(); BadArgument for an address that is not a loopback one without `anyAddress`, for
    /// a bus id that cannot travel or is there twice.
    static Result<std::unique_ptr<UsbipServer>> serve(Scheduler& scheduler, std::vector<UsbipExport> exports,
                                                      const UsbipServerOptions& options = {}, Log log = {});
    ~UsbipServer();
    UsbipServer(const UsbipServer&) = delete;
    UsbipServer& operator=(const UsbipServer&) = delete;

    std::uint16_t port() const;
    UsbipServerReport report() const;

  private:
    class Impl;
    explicit UsbipServer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace kickstand
