#pragma once

#include "app/kickstand-sim/simulation.h"
#include "core/smartdevice/sim/smartdevice_sim.h"

namespace kickstand::sim {

/// Simulated boards of the kit, each of which is a unit.
class BoardSimulation final : public Simulation {
  public:
    BoardSimulation(Scheduler& scheduler, const smartdevice::sim::SmartDeviceSimOptions& options)
        : sim_(scheduler, options) {}

    ByteDeviceModel& device(int number) { return sim_.board(number); }
    int count() const { return sim_.count(); }

    const char* family() const override { return "smartdevice"; }
    QString description() const override;
    const char* unitName() const override { return "device"; }
    std::vector<int> units() const override { return sim_.units(); }
    SimControl& control() override { return sim_; }
    std::vector<ValueWord> valueWords() const override { return {}; }
    std::vector<ValueWord> shortcuts() const override {
        return {{"plugged", "unplug", 0}, {"plugged", "replug", 1}};
    }
    QJsonObject show() override;
    QJsonObject showUnit(int unit) const override;
    std::uint32_t flashBytes() const override { return 0; }
    void readFlash(int /*unit*/, std::uint32_t /*address*/, ByteSpan /*into*/) const override {}

  private:
    // Looking at a board lets its time pass.
    mutable smartdevice::sim::SmartDeviceSim sim_;
};

}  // namespace kickstand::sim
