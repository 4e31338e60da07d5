#pragma once

#include "app/kickstand-sim/simulation.h"
#include "core/motionplan/sim/nxt_sim.h"

namespace kickstand::sim {

/// One NXT with motion plans. There are no units: everything is of the one robot.
class NxtSimulation final : public Simulation {
  public:
    NxtSimulation(Scheduler& scheduler, const motionplan::sim::NxtOptions& options)
        : sim_(scheduler, options) {}

    ByteDeviceModel& device() { return sim_; }

    const char* family() const override { return "motionplan"; }
    QString description() const override;
    const char* unitName() const override { return "nxt"; }
    std::vector<int> units() const override { return {}; }
    SimControl& control() override { return sim_.control(); }
    std::vector<ValueWord> valueWords() const override;
    std::vector<ValueWord> shortcuts() const override;
    QJsonObject show() override;
    QJsonObject showUnit(int unit) const override;
    std::uint32_t flashBytes() const override { return 0; }
    void readFlash(int unit, std::uint32_t address, ByteSpan into) const override;

  private:
    motionplan::sim::NxtSim sim_;
};

}  // namespace kickstand::sim
