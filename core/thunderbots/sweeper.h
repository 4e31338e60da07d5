#pragma once

#include <vector>

#include "core/thunderbots/snapshot.h"

namespace kickstand::thunderbots {

/// Works through a sweep, one kick after another, each with a charged capacitor and after what the one before
/// did is known. Decides when a kick is due; the session gives it, by its rules. Engine thread.
class Sweeper {
  public:
    /// What look() found.
    enum class Finding : std::uint8_t { Wait, Kick, Through, NotCharged, Unknown };

    /// From here on look() finds kicks to be due. `kicks` is what planSweep() made of the plan, not empty.
    void begin(const SweepPlan& plan, std::vector<wire::KickTimes> kicks, bool chargerWasOn, TimePoint now);
    /// No more kicks: through, or for this reason.
    void end(std::optional<Errc> why);
    bool running() const { return progress_ && progress_->running(); }
    bool running(int robot) const { return running() && progress_->plan.robot == robot; }
    int robot() const { return progress_ ? progress_->plan.robot : -1; }
    /// Looks at the robot, while running. `measuring`: what its last kick did is not known yet. Kick: the
    /// next is due. Through: all were given and measured. NotCharged: charging takes too long. Unknown:
    /// nobody knows the voltage.
    Finding look(const RobotState& state, bool measuring, TimePoint now);
    /// The kick that is due.
    const wire::KickTimes& due() const { return kicks_[static_cast<std::size_t>(progress_->given)]; }
    /// It was handed in.
    void kicked(TimePoint now);
    /// What was handed in last was not given to the dongle after all.
    void kickFailed() { --progress_->given; }

    /// Whether the charger ran before the sweep.
    bool chargerWasOn() const { return chargerWasOn_; }
    /// Tells one sweep of this session from another.
    std::uint64_t number() const { return number_; }
    const std::optional<SweepProgress>& progress() const { return progress_; }

  private:
    void setStage(SweepStage stage) { progress_->stage = stage; }

    std::vector<wire::KickTimes> kicks_;
    std::optional<SweepProgress> progress_;
    std::uint64_t number_ = 0;
    TimePoint waitingSince_{};  ///< Since then the capacitor has not been charged.
    std::optional<TimePoint> lastKick_;
    bool chargerWasOn_ = false;
};

}  // namespace kickstand::thunderbots
