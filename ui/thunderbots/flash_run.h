#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/thunderbots/flash_plan.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// How far one robot of a run has come.
enum class FlashOutcome {
    Asked,  ///< The engine has not answered yet.
    Running,
    Paused,
    Done,
    Failed,
    Cancelled,
    Refused,  ///< It was never begun.
    Gone,     ///< The link was let go meanwhile.
};

/// One robot of a run.
struct FlashRunRobot {
    std::vector<thunderbots::SharedFlashPlan> plans;
    std::optional<Error> refusal;
    /// As last seen: it outlives the link.
    std::optional<thunderbots::FlashProgress> progress;
    bool gone = false;

    FlashOutcome outcome() const;
    bool ended() const { return outcome() >= FlashOutcome::Done; }
};

/// The uploads that a person started together, followed to their ends. What is known of them stays when the
/// link goes. Pure.
class FlashRun {
  public:
    /// Forgets the run before. `now`: on the engine's clock, before anything is asked for.
    void begin(TimePoint now);
    void add(int robot, std::vector<thunderbots::SharedFlashPlan> plans);
    /// The engine will not have it.
    void refuse(int robot, const Error& error);
    /// Takes over how the uploads go.
    void take(const thunderbots::Snapshot& snapshot);
    /// The session is no more: what ran has no end that anybody heard of.
    void letGo();

    thunderbots::RobotMask robots() const { return robots_; }
    const FlashRunRobot& at(int robot) const { return all_[static_cast<std::size_t>(robot)]; }
    /// Those with this outcome.
    thunderbots::RobotMask with(FlashOutcome outcome) const;
    /// Those that have come to an end, whichever.
    thunderbots::RobotMask ended() const;
    bool running() const { return ended() != robots_; }
    /// Those that a person will want to try again: neither done, nor under way.
    thunderbots::RobotMask unfinished() const;

  private:
    thunderbots::RobotMask robots_ = 0;
    TimePoint begunAt_{};
    std::array<FlashRunRobot, thunderbots::kRobots> all_;
};

}  // namespace kickstand::ui
