#pragma once

#include <cstdint>
#include <vector>

#include "core/thunderbots/sim/robot_sim.h"
#include "core/thunderbots/sim/timers.h"
#include "core/thunderbots/sim/usb_side.h"

namespace kickstand::thunderbots::sim {

/// A robot on a USB cable (protocol 3.11): the dongle's endpoints without radios, channels, e-stop and
/// dead-man. The robot itself is the device: while it is off, locked out or boots, nothing is plugged in. On
/// the scheduler's thread.
class CableSim final : private UsbSideOwner {
  public:
    /// `robot` must outlive it.
    CableSim(Scheduler& scheduler, RobotSim& robot);

    UsbSide& usb() { return usb_; }
    const UsbSide& usb() const { return usb_; }

    /// Plugs the cable in or pulls it out; the robot lives on.
    void setPlugged(bool plugged);
    bool plugged() const { return plugged_; }

    // For a look.
    wire::DongleStatus status() const override;

  private:
    void configured(bool configured) override;
    UsbHandshake vendorRequest(const UsbSetup& setup, std::vector<std::uint8_t>& in) override;
    void statePacketCame() override { robot_.refreshDrive(); }
    void driveBlockCame(std::uint8_t robot, ByteView block) override;
    bool roomForMessage() const override { return true; }
    void messageCame(std::uint8_t robot, wire::Pipe pipe, ByteView payload) override;
    void messageTaken() override;

    void tick();
    void offerMessage();
    void updateAttachment();

    RobotSim& robot_;
    UsbSide usb_;
    Timer tick_;
    Timers soon_;
    bool plugged_ = true;
    bool messageOffered_ = false;
};

}  // namespace kickstand::thunderbots::sim
