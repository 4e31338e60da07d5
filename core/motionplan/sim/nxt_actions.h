#pragma once

#include "core/link/sim_control.h"

namespace kickstand::motionplan::sim {

class NxtSim;

/// What a hand can do to a simulated NXT: `plugged`, `loss`, `reply-loss`, `duplicate`, `delay`, `lose-next`,
/// `lose-next-out`, `lose-one-out`, `text`, `program`, `pace`, `strict-update`, `error`.
class NxtActions final : public SimControl {
  public:
    /// `sim` must outlive it.
    explicit NxtActions(NxtSim& sim) : sim_(sim) {}

    std::vector<SimAction> actions() const override;
    Result<void> perform(std::string_view action, int unit, double value) override;
    std::optional<double> value(std::string_view action, int unit) const override;

  private:
    NxtSim& sim_;
};

}  // namespace kickstand::motionplan::sim
