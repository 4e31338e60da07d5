#pragma once

#include <cstdint>
#include <memory>

#include "core/link/sim_control.h"
#include "core/link/usb_device_model.h"
#include "core/thunderbots/sim/robot_report.h"
#include "core/thunderbots/sim/sim_options.h"

namespace kickstand::thunderbots::sim {

class SimWorld;

/// What a test may want to know about a simulated dongle or cable.
struct DeviceReport {
    bool attached = false;
    bool configured = false;  ///< By a host.
    wire::DongleStatus status;
    wire::Channels channels;       ///< The dongle's; the defaults for a cable.
    std::size_t messagesHeld = 0;  ///< For robots, in the dongle's buffers.
    std::uint64_t malformed = 0;   ///< OUT packets, or parts of them, that made no sense.
};

/// Simulated robots and the device through which a host reaches them: the other end of a Thunderbots link.
/// Every method is called on the thread of the scheduler it was made with; time passes by that scheduler
/// alone.
class ThunderbotsSim {
  public:
    /// Everything is switched on and plugged in. `scheduler` outlives it.
    ThunderbotsSim(Scheduler& scheduler, const ThunderbotsSimOptions& options = {});
    ~ThunderbotsSim();
    ThunderbotsSim(const ThunderbotsSim&) = delete;
    ThunderbotsSim& operator=(const ThunderbotsSim&) = delete;

    /// The USB device: a dongle, or the robot on the cable. Lives as long as this.
    UsbDeviceModel& device();
    /// What a hand can do to it all. Lives as long as this.
    SimControl& control();

    /// Whether there is a robot that came into being with this number.
    bool hasRobot(int unit) const;
    /// Everything about that robot at this moment; a default report where there is none.
    RobotReport robot(int unit) const;
    /// Copies from the robot's SPI flash. False, and nothing done, for a range that leaves it or no such
    /// robot.
    bool readFlash(int unit, std::uint32_t address, ByteSpan into) const;
    DeviceReport deviceReport() const;

  private:
    std::unique_ptr<SimWorld> world_;
    std::unique_ptr<SimControl> control_;
};

}  // namespace kickstand::thunderbots::sim
