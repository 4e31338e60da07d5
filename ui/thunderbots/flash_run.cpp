#include "ui/thunderbots/flash_run.h"

#include <utility>

namespace kickstand::ui {

using namespace thunderbots;

FlashOutcome FlashRunRobot::outcome() const {
    if (refusal) return FlashOutcome::Refused;
    if (gone) return FlashOutcome::Gone;
    if (!progress) return FlashOutcome::Asked;
    switch (progress->stage) {
        case FlashStage::Done:
            return FlashOutcome::Done;
        case FlashStage::Failed:
            return FlashOutcome::Failed;
        case FlashStage::Cancelled:
            return FlashOutcome::Cancelled;
        default:
            return progress->paused ? FlashOutcome::Paused : FlashOutcome::Running;
    }
}

void FlashRun::begin(TimePoint now) {
    robots_ = 0;
    begunAt_ = now;
    all_ = {};
}

void FlashRun::add(int robot, std::vector<SharedFlashPlan> plans) {
    robots_ |= maskOf(robot);
    all_[static_cast<std::size_t>(robot)].plans = std::move(plans);
}

void FlashRun::refuse(int robot, const Error& error) {
    FlashRunRobot& entry = all_[static_cast<std::size_t>(robot)];
    if (!entry.progress) entry.refusal = error;
}

void FlashRun::take(const Snapshot& snapshot) {
    for (int robot = 0; robot < kRobots; ++robot) {
        FlashRunRobot& entry = all_[static_cast<std::size_t>(robot)];
        const auto& progress = snapshot.flash[static_cast<std::size_t>(robot)];
        // The snapshot also has the upload before this one, and what came after a link was let go is of
        // somebody else.
        const bool own = progress && progress->beganAt >= begunAt_;
        if (contains(robots_, robot) && own && !entry.ended()) entry.progress = progress;
    }
}

void FlashRun::letGo() {
    for (int robot = 0; robot < kRobots; ++robot) {
        FlashRunRobot& entry = all_[static_cast<std::size_t>(robot)];
        if (contains(robots_, robot) && !entry.ended()) entry.gone = true;
    }
}

RobotMask FlashRun::with(FlashOutcome outcome) const {
    RobotMask mask = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (contains(robots_, robot) && at(robot).outcome() == outcome) mask |= maskOf(robot);
    }
    return mask;
}

RobotMask FlashRun::ended() const {
    RobotMask mask = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (contains(robots_, robot) && at(robot).ended()) mask |= maskOf(robot);
    }
    return mask;
}

RobotMask FlashRun::unfinished() const {
    return static_cast<RobotMask>(ended() & ~with(FlashOutcome::Done));
}

}  // namespace kickstand::ui
