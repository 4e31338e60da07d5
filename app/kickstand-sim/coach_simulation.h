#pragma once

#include "app/kickstand-sim/simulation.h"
#include "core/coach/sim/coach_sim.h"

namespace kickstand::sim {

/// Simulated radio modules, with the boats and COACHes that they hear. show() prints what the modules are set
/// to and have sent, showUnit() what a boat received and does: levels −7 to 7, and percentages ("…_percent").
class CoachSimulation final : public Simulation {
  public:
    CoachSimulation(Scheduler& scheduler, const coach::sim::CoachSimOptions& options)
        : sim_(scheduler, options) {}

    coach::sim::CoachSim& sim() { return sim_; }

    const char* family() const override { return "coach"; }
    QString description() const override;
    const char* unitName() const override { return "team"; }
    std::vector<int> units() const override { return sim_.units(); }
    SimControl& control() override { return sim_; }
    std::vector<ValueWord> valueWords() const override { return {}; }
    std::vector<ValueWord> shortcuts() const override;
    QJsonObject show() override;
    QJsonObject showUnit(int unit) const override;
    std::uint32_t flashBytes() const override { return 0; }
    void readFlash(int, std::uint32_t, ByteSpan) const override {}

  private:
    coach::sim::CoachSim sim_;
};

}  // namespace kickstand::sim
