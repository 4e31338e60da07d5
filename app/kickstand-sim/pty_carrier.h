#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/kickstand-sim/simulation.h"
#include "app/kickstandctl/failure.h"
#include "core/link/pty/pty_port.h"

namespace kickstand::sim {

/// A simulated device and the name that its pseudo-terminal is to have.
struct ServedLine {
    ByteDeviceModel* device = nullptr;
    std::string path;
};

/// Serves simulated devices on pseudo-terminals. On the scheduler's thread.
class PtyCarrier final : public Carrier {
  public:
    /// Begins to serve. Scheduler and devices must outlive it. `link` is what follows a path in a link URI,
    /// as in "?protocol=coach". A path that something else has is exit 1.
    static ctl::Expected<std::unique_ptr<PtyCarrier>> serve(Scheduler& scheduler,
                                                            const std::vector<ServedLine>& lines,
                                                            QString link);

    QJsonObject report() const override;
    QStringList howToReach() const override;

  private:
    explicit PtyCarrier(QString link) : link_(std::move(link)) {}

    struct Port {
        std::string path;
        std::unique_ptr<PtyPort> port;
    };
    QString uriOf(const Port& port) const;

    const QString link_;
    std::vector<Port> ports_;
};

}  // namespace kickstand::sim
