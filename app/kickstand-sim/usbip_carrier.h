#pragma once

#include <functional>
#include <memory>

#include "app/kickstand-sim/simulation.h"
#include "app/kickstandctl/failure.h"
#include "core/usbip/usbip_server.h"

namespace kickstand::sim {

/// Serves one simulated USB device over USB/IP under the bus id 1-1. On the scheduler's thread.
class UsbipCarrier final : public Carrier {
  public:
    /// Begins to serve. Scheduler and device must outlive it. An address that other machines reach without
    /// leave to do so is exit 2, a port in use exit 1; both say what to do.
    static ctl::Expected<std::unique_ptr<UsbipCarrier>> serve(Scheduler& scheduler, UsbDeviceModel& device,
                                                              const UsbipServerOptions& options,
                                                              UsbipServer::Log log);

    QJsonObject report() const override;
    QStringList howToReach() const override;

  private:
    UsbipCarrier(std::unique_ptr<UsbipServer> server, std::string address);

    std::unique_ptr<UsbipServer> server_;
    const std::string address_;
};

}  // namespace kickstand::sim
