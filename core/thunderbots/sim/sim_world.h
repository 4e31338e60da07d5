#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/thunderbots/sim/cable_sim.h"
#include "core/thunderbots/sim/dongle_sim.h"
#include "core/thunderbots/sim/sim_options.h"

namespace kickstand::thunderbots::sim {

/// Everything that is simulated together: the robots and the one device through which they are reached. On
/// the scheduler's thread.
class SimWorld {
  public:
    /// Makes the robots and the device that the options ask for. `scheduler` outlives it.
    SimWorld(Scheduler& scheduler, const ThunderbotsSimOptions& options);
    SimWorld(const SimWorld&) = delete;
    SimWorld& operator=(const SimWorld&) = delete;

    /// The robot that came into being with this number, whatever it calls itself now; null where there is
    /// none.
    RobotSim* robot(int unit) const;
    const std::vector<std::unique_ptr<RobotSim>>& robots() const { return robots_; }
    RadioMedium& medium() { return medium_; }
    const RadioMedium& medium() const { return medium_; }
    /// Null where a robot is on a cable, as `cable` is null where there is a dongle.
    DongleSim* dongle() const { return dongle_.get(); }
    CableSim* cable() const { return cable_.get(); }
    UsbSide& usb() const { return dongle_ ? dongle_->usb() : cable_->usb(); }

  private:
    std::vector<std::unique_ptr<RobotSim>> robots_;
    std::vector<int> units_;
    std::vector<RobotRadio> radios_;
    RadioMedium medium_;
    std::unique_ptr<DongleSim> dongle_;
    std::unique_ptr<CableSim> cable_;
};

}  // namespace kickstand::thunderbots::sim
