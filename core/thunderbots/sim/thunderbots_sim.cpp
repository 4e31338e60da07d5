#include "core/thunderbots/sim/thunderbots_sim.h"

#include "core/thunderbots/sim/sim_actions.h"
#include "core/thunderbots/sim/sim_world.h"

namespace kickstand::thunderbots::sim {

ThunderbotsSim::ThunderbotsSim(Scheduler& scheduler, const ThunderbotsSimOptions& options)
    : world_(std::make_unique<SimWorld>(scheduler, options)),
      control_(std::make_unique<SimActions>(*world_)) {}

ThunderbotsSim::~ThunderbotsSim() = default;

UsbDeviceModel& ThunderbotsSim::device() {
    return world_->usb();
}

SimControl& ThunderbotsSim::control() {
    return *control_;
}

bool ThunderbotsSim::hasRobot(int unit) const {
    return world_->robot(unit) != nullptr;
}

RobotReport ThunderbotsSim::robot(int unit) const {
    RobotSim* robot = world_->robot(unit);
    return robot ? robot->report() : RobotReport{};
}

bool ThunderbotsSim::readFlash(int unit, std::uint32_t address, ByteSpan into) const {
    const RobotSim* robot = world_->robot(unit);
    const bool inside = address <= wire::kFlashBytes && into.size() <= wire::kFlashBytes - address;
    if (!robot || !inside) return false;
    robot->flash().read(address, into);
    return true;
}

DeviceReport ThunderbotsSim::deviceReport() const {
    DeviceReport report;
    report.attached = world_->usb().attached();
    report.configured = world_->usb().configured();
    report.malformed = world_->usb().malformed();
    if (const DongleSim* dongle = world_->dongle()) {
        report.status = dongle->status();
        report.channels = dongle->channels();
        report.messagesHeld = dongle->messagesHeld();
    } else {
        report.status = world_->cable()->status();
    }
    return report;
}

}  // namespace kickstand::thunderbots::sim
