#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/link/link_uri.h"
#include "core/link/sim_control.h"
#include "core/smartdevice/sim/board_sim.h"

namespace kickstand::smartdevice::sim {

/// One board to be simulated.
struct BoardOptions {
    std::string kind;
    wire::Dialect dialect = wire::Dialect::Current;
};

/// Which boards there are.
struct SmartDeviceSimOptions {
    std::vector<BoardOptions> boards;
    Duration boot = std::chrono::milliseconds(600);  ///< From the opening of a line to its first answer.
    double noise = 0;                                ///< Probability, 0-1, that a byte on a line is damaged.
    std::size_t longestData = kUsualLongestData;     ///< Longer Data comes in several messages; bytes.
    std::uint32_t seed = 1;
};

/// The options of a `sim:smartdevice` URI: `devices=PolarBear,Encoder.hibike`, `boot_ms=600`, `noise=0.001`,
/// `seed=1`, `data_bytes=40`; without `devices` six boards of different kinds. Errors: UnknownName,
/// OutOfRange, BadArgument. Any thread.
Result<SmartDeviceSimOptions> parseSimOptions(const LinkUri& uri);

/// The names of all kinds that can be simulated, for an error that says what there is. Any thread.
std::string knownKinds();

/// Boards on a bench, each on a line of its own. The scheduler's thread.
class SmartDeviceSim final : public SimControl {
  public:
    SmartDeviceSim(Scheduler& scheduler, const SmartDeviceSimOptions& options);

    int count() const { return static_cast<int>(boards_.size()); }
    BoardSim& board(int number) { return *boards_.at(static_cast<std::size_t>(number)); }
    const std::string& kind(int number) const { return kinds_.at(static_cast<std::size_t>(number)); }
    /// "simulated 0: PolarBear": the name of the port that the board is at.
    std::string portName(int number) const;
    /// Told after a board was plugged in or pulled out.
    void setPlugListener(std::function<void()> listener) { plugged_ = std::move(listener); }

    std::vector<SimAction> actions() const override;
    std::vector<int> units() const override;
    Result<void> perform(std::string_view action, int unit, double value) override;
    std::optional<double> value(std::string_view action, int unit) const override;

  private:
    Result<void> performOn(std::string_view action, int unit, double value);

    Supply supply_;
    std::vector<std::unique_ptr<BoardSim>> boards_;
    std::vector<std::string> kinds_;
    std::function<void()> plugged_;
};

}  // namespace kickstand::smartdevice::sim
