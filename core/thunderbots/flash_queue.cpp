#include "core/thunderbots/flash_queue.h"

#include <utility>

namespace kickstand::thunderbots {
namespace {

/// Often enough for a person to watch.
constexpr Duration kTickEvery = std::chrono::milliseconds(100);

}  // namespace

FlashQueue::FlashQueue(Scheduler& scheduler, RobotRequests& requests,
                       std::function<Result<void>(int robot)> mayChange, std::function<bool()> onCable,
                       std::function<std::optional<wire::Channels>()> channels,
                       std::function<void(int robot)> paused, Ended ended)
    : around_{.scheduler = scheduler,
              .requests = requests,
              .mayChange = std::move(mayChange),
              .onCable = std::move(onCable),
              .channels = std::move(channels),
              .changed = [this] { ++version_; },
              .paused = std::move(paused),
              .ended = std::move(ended)} {}

void FlashQueue::start(int robot, std::vector<SharedFlashPlan> plans) {
    at(robot) = std::make_unique<FlashUploader>(robot, std::move(plans), around_);
    at(robot)->start();
    ++version_;
}

void FlashQueue::cancel(int robot) {
    if (running(robot)) at(robot)->cancel();
}

void FlashQueue::pause() {
    for (const Uploader& uploader : uploaders_) {
        if (uploader) uploader->pause();
    }
}

void FlashQueue::resume(int robot) {
    if (running(robot)) at(robot)->resume();
}

void FlashQueue::found(int robot) {
    if (running(robot)) at(robot)->found();
}

void FlashQueue::lost(int robot, Errc why) {
    if (running(robot)) at(robot)->lost(why);
}

void FlashQueue::tick(TimePoint now) {
    if (now - tickedAt_ < kTickEvery) return;
    tickedAt_ = now;
    for (const Uploader& uploader : uploaders_) {
        if (uploader) uploader->tick();
    }
}

}  // namespace kickstand::thunderbots
