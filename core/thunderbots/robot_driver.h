#pragma once

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand::thunderbots {

/// What one robot has been asked to do, and the drive block that comes of it: limits, the ramp, and the rule
/// that a held input must have been at zero. Pure: no link, no clock. Engine thread.
class RobotDriver {
  public:
    const RobotIntent& intent() const { return intent_; }

    /// Back to a braked robot with everything off and disarmed; held inputs must pass zero again.
    void halt();
    /// Asks for wheel speeds. A `held` input that is not at zero is refused (MustPassZero) until it has been.
    /// Errors: OutOfRange past `limit`, naming the wheel.
    Result<void> setWheels(const WheelSpeeds& wheels, bool held, int limit, TimePoint now);
    /// A held input was refused for another reason: it must pass zero before it counts.
    void refuseHeld() { intent_.mustPassZero = true; }
    /// A held input is at zero while nothing may move: that counts as having passed it.
    void noteZero() { intent_.mustPassZero = false; }
    /// Brings what was asked for within a lower limit. True when that changed anything.
    bool clampTo(int limit);
    void brake();
    void setDribbler(bool on) { intent_.dribbler = on; }
    /// Disarming switches off what needs it.
    void armHighVoltage(bool armed);
    void setCharger(bool on) { intent_.charger = on; }
    void setAutokick(bool armed, const wire::KickTimes& times);
    void setTestMode(const wire::TestMode& mode) { intent_.driveTestMode = mode; }
    void setDischarging(bool discharging);
    /// A sweep needs the robot to itself: autokick goes off.
    void setSweeping(bool sweeping);
    /// A check has the robot to itself: all that it was doing ends. So does all that the check had it do.
    void setChecking(bool checking);

    /// Lets the ramp go on to `now`. Without a ramp, or towards zero, the wheels follow at once.
    void advance(TimePoint now, bool ramped);
    /// Whether the ramp has still some way to go.
    bool ramping() const { return intent_.run && intent_.commanded != intent_.target; }

    /// The block for the wire, as things are.
    wire::DriveBlock block() const;

  private:
    RobotIntent intent_;
    TimePoint advancedAt_{};
    std::array<double, kWheels> exact_{};  ///< The ramp's position, with its fractions.
};

}  // namespace kickstand::thunderbots
