#pragma once

#include "core/link/sim_control.h"
#include "core/thunderbots/sim/sim_world.h"

namespace kickstand::thunderbots::sim {

/// What a hand can do to the simulated robots and their dongle or cable. Robots are named by the number that
/// they came into being with. For a robot: `ball`, `battery`, `capacitor`, `temperature`, `dead-wheels`,
/// `broken-charger`, `dead` (0 switches a robot on that was off or locked out), `experiment`. For both
/// devices: `plugged`, `stall`, `error`. For a dongle: `e-stop`, `radio-failure`, `loss`, `duplicate`,
/// `delay`.
class SimActions final : public SimControl {
  public:
    /// `world` must outlive it.
    explicit SimActions(SimWorld& world) : world_(world) {}

    std::vector<SimAction> actions() const override;
    std::vector<int> units() const override;
    Result<void> perform(std::string_view action, int unit, double value) override;
    std::optional<double> value(std::string_view action, int unit) const override;

  private:
    SimWorld& world_;
};

}  // namespace kickstand::thunderbots::sim
