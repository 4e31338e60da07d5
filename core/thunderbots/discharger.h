#pragma once

#include <array>
#include <functional>
#include <optional>

#include "core/base/scheduler.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand::thunderbots {

/// Empties capacitors with short pulses, one robot after another as their turn comes: 96 µs at a time, too
/// short to move a ball, until 25 V (protocol 6.3). Decides when a pulse is due; the session sends it. Engine
/// thread.
class Discharger {
  public:
    /// The pulse: solenoid 1 for three steps of 32 µs.
    static constexpr wire::KickTimes kPulse{true, true, 3, 0, 0};

    /// What step() found.
    enum class Finding : std::uint8_t { Wait, Pulse, Empty, NoEffect, Unknown };

    /// From here on look() finds pulses to be due. `capacitor_V` is what there is to begin with.
    void begin(int robot, double capacitor_V, TimePoint now);
    /// No more pulses for this robot; nothing where it is not being discharged.
    void end(int robot);
    bool running(int robot) const { return runs_[static_cast<std::size_t>(robot)].has_value(); }
    /// Looks at a robot that is being discharged. Pulse: one is due now. Empty: below 25 V. NoEffect: the
    /// voltage does not fall any more. Unknown: nobody knows the voltage.
    Finding look(int robot, const RobotState& state, TimePoint now);
    /// A pulse was given.
    void pulsed(int robot, TimePoint now);

  private:
    struct Run {
        TimePoint nextPulse{};
        double lowest_V = 0;
        int pulsesSinceLower = 0;
    };
    std::array<std::optional<Run>, kRobots> runs_;
};

}  // namespace kickstand::thunderbots
