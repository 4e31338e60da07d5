#include "core/smartdevice/sim/simulated_ports.h"

#include <utility>

#include "core/link/paced/paced_byte_link.h"

namespace kickstand::smartdevice::sim {
namespace {

/// A link to a port that does not exist.
class NoLink final : public ByteLink {
  public:
    NoLink(Scheduler& scheduler, std::string port) : scheduler_(scheduler), port_(std::move(port)) {}

    void open(std::function<void(Result<ByteLinkInfo>)> done) override {
        scheduler_.post([done = std::move(done), port = port_] {
            Error error;
            error.code = Errc::NoDevice;
            error.port = port;
            done(fail(std::move(error)));
        });
    }
    void close(std::function<void()> done) override {
        if (done) scheduler_.post(std::move(done));
    }
    Result<void> write(ByteView /*bytes*/) override { return fail(Errc::NotConnected, "link"); }
    std::size_t waiting() const override { return 0; }
    void setBaud(Baud /*baud*/, std::function<void(Result<void>)> done) override {
        scheduler_.post([done = std::move(done)] { done(fail(Errc::NotConnected, "link")); });
    }
    void setReceiver(std::function<void(ByteView)> /*receiver*/) override {}
    void setPresenceListener(std::function<void(bool)> /*listener*/) override {}

  private:
    Scheduler& scheduler_;
    const std::string port_;
};

class SimulatedPorts final : public BytePorts {
  public:
    SimulatedPorts(Scheduler& scheduler, SmartDeviceSim& sim, const ByteFaultOptions& faults)
        : scheduler_(scheduler), sim_(sim), faults_(faults) {
        sim_.setPlugListener([this] { tellSoon(); });
    }
    ~SimulatedPorts() override { sim_.setPlugListener(nullptr); }
    SimulatedPorts(const SimulatedPorts&) = delete;
    SimulatedPorts& operator=(const SimulatedPorts&) = delete;

    void watch(std::function<void(const std::vector<BytePort>&)> changed) override {
        changed_ = std::move(changed);
        tellSoon();
    }

    std::unique_ptr<ByteLink> makeLink(const std::string& name, Baud baud) override {
        for (int i = 0; i < sim_.count(); ++i) {
            if (name != sim_.portName(i)) continue;
            PacedLineOptions options;
            options.port = name;
            options.description = sim_.kind(i);
            options.baud = baud;
            options.faults = faults_;
            options.faults.seed += static_cast<std::uint32_t>(i);
            return std::make_unique<PacedByteLink>(scheduler_, sim_.board(i), std::move(options));
        }
        return std::make_unique<NoLink>(scheduler_, name);
    }

  private:
    void tellSoon() {
        scheduler_.post([this, alive = std::weak_ptr(alive_)] {
            if (alive.expired()) return;
            std::vector<BytePort> ports;
            for (int i = 0; i < sim_.count(); ++i) {
                if (!sim_.board(i).attached()) continue;
                ports.emplace_back();
                ports.back().name = sim_.portName(i);
                ports.back().description = "Arduino Micro (simulated)";
            }
            // A copy, because the listener may end the watch.
            if (const auto changed = changed_) changed(ports);
        });
    }

    Scheduler& scheduler_;
    SmartDeviceSim& sim_;
    const ByteFaultOptions faults_;
    std::function<void(const std::vector<BytePort>&)> changed_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
};

}  // namespace

std::unique_ptr<BytePorts> makeSimulatedPorts(Scheduler& scheduler, SmartDeviceSim& sim,
                                              const ByteFaultOptions& faults) {
    return std::make_unique<SimulatedPorts>(scheduler, sim, faults);
}

}  // namespace kickstand::smartdevice::sim
