#pragma once

#include "app/kickstand-sim/simulation.h"
#include "core/base/scheduler.h"
#include "core/thunderbots/sim/thunderbots_sim.h"

namespace kickstand::sim {

/// Thunderbots robots and their dongle or cable. What show() and showUnit() print:
/// times are seconds of the simulator's clock since it began ("…_s"), voltages volts ("…_V"), pulses
/// microseconds ("…_us"), wheel speeds quarter-degrees per 5 ms.
class ThunderbotsSimulation final : public Simulation {
  public:
    ThunderbotsSimulation(Scheduler& scheduler, const thunderbots::sim::ThunderbotsSimOptions& options);

    UsbDeviceModel& device() { return sim_.device(); }

    const char* family() const override { return "thunderbots"; }
    QString description() const override;
    const char* unitName() const override { return "robot"; }
    std::vector<int> units() const override;
    SimControl& control() override { return sim_.control(); }
    std::vector<ValueWord> valueWords() const override;
    std::vector<ValueWord> shortcuts() const override;
    QJsonObject show() override;
    QJsonObject showUnit(int unit) const override;
    std::uint32_t flashBytes() const override;
    void readFlash(int unit, std::uint32_t address, ByteSpan into) const override;

  private:
    QJsonObject driveToJson(const thunderbots::sim::RobotReport& robot) const;
    QJsonObject kicksToJson(const thunderbots::sim::RobotReport& robot) const;
    /// Seconds since the simulator began.
    double since(TimePoint time) const;

    Scheduler& scheduler_;
    const TimePoint start_;
    const bool cable_;
    thunderbots::sim::ThunderbotsSim sim_;
};

}  // namespace kickstand::sim
