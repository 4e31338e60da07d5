#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/thunderbots/flash_uploader.h"
#include "core/thunderbots/types.h"

namespace kickstand::thunderbots {

/// The uploads to sixteen robots: at the same time, each for itself; what they send takes turns
/// (MessageTurns). Engine thread.
class FlashQueue {
  public:
    using Ended = std::function<void(int robot, const FlashProgress& progress)>;

    /// As FlashSurroundings has them.
    FlashQueue(Scheduler& scheduler, RobotRequests& requests,
               std::function<Result<void>(int robot)> mayChange, std::function<bool()> onCable,
               std::function<std::optional<wire::Channels>()> channels, std::function<void(int robot)> paused,
               Ended ended);

    /// Begins an upload, in the place of the robot's last one, which must have ended.
    void start(int robot, std::vector<SharedFlashPlan> plans);
    void cancel(int robot);
    /// All of them, as FlashUploader.
    void pause();
    void resume(int robot);
    void found(int robot);
    void lost(int robot, Errc why);
    /// Time has passed.
    void tick(TimePoint now);

    bool running(int robot) const { return at(robot) && at(robot)->running(); }
    bool expectsLoss(int robot) const { return at(robot) && at(robot)->expectsLoss(); }
    /// The upload that runs, or the last one that did; null for none.
    const FlashProgress* progress(int robot) const { return at(robot) ? &at(robot)->progress() : nullptr; }
    /// Rises whenever something to be shown has changed.
    std::uint64_t version() const { return version_; }

  private:
    using Uploader = std::unique_ptr<FlashUploader>;
    Uploader& at(int robot) { return uploaders_[static_cast<std::size_t>(robot)]; }
    const Uploader& at(int robot) const { return uploaders_[static_cast<std::size_t>(robot)]; }

    std::uint64_t version_ = 0;
    FlashSurroundings around_;
    std::array<Uploader, kRobots> uploaders_;
    TimePoint tickedAt_{};
};

}  // namespace kickstand::thunderbots
