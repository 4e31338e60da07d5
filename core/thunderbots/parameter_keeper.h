#pragma once

#include <array>

#include "core/thunderbots/parameter_state.h"
#include "core/thunderbots/types.h"

namespace kickstand::thunderbots {

/// Remembers what sixteen robots have said about their parameters, and what follows from that about what
/// outlives a reboot. Passive: it is told, it never asks. Engine thread.
class ParameterKeeper {
  public:
    const ParameterState& state(int robot) const { return at(robot).state; }
    /// Rises whenever a state() changes.
    std::uint64_t version() const { return version_; }

    /// What the robot has answered.
    void read(int robot, const wire::OperationalParameters& parameters, TimePoint time);
    void signaturesRead(int robot, const wire::ReadSignaturesResponse& signatures, TimePoint time);
    /// It has taken these into its volatile copy, and has been read again since.
    void applied(int robot);
    /// It has committed what it was last read to have.
    void committed(int robot);
    /// Erasing loads the block again and commits it changed: nothing that was known holds (protocol 4.7).
    void erased(int robot);
    /// It will reboot, and vanish. From when it has, what is applied is gone, and what is committed shows.
    void willReboot(int robot);
    /// The dongle has lost it. `others`: the robots that are alive now. One that rebooted to another number
    /// which nobody else answers to is expected there.
    void lost(int robot, RobotMask others);
    /// It was told to reboot a moment ago, and has done so without the dongle's having missed it. Nothing
    /// where it comes back under another number: that the dongle notices.
    void rebootedUnseen(int robot);
    /// Whether the robot's next reading proves or disproves a commit.
    bool proofDue(int robot) const { return state(robot).standing == ParameterStanding::Rebooted; }

  private:
    struct Entry {
        ParameterState state;
        bool rebooting = false;
    };
    Entry& at(int robot) { return entries_[static_cast<std::size_t>(robot)]; }
    const Entry& at(int robot) const { return entries_[static_cast<std::size_t>(robot)]; }

    std::array<Entry, kRobots> entries_;
    std::uint64_t version_ = 0;
};

}  // namespace kickstand::thunderbots
