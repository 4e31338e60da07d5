#include "ui/thunderbots/flash_wizard_state.h"

#include <algorithm>
#include <utility>

#include "core/thunderbots/flash_estimate.h"

namespace kickstand::ui {

using namespace thunderbots;
using image::FlashTarget;
using Kind = FlashHold::Kind;

namespace {

/// What the robots share is the wire to the dongle, a message a millisecond: five fill a page, one programs
/// it.
constexpr Duration kPageOnWire = std::chrono::milliseconds(6);

Duration onWire(const std::vector<SharedFlashPlan>& plans) {
    Duration sum{};
    for (const SharedFlashPlan& plan : plans)
        sum += kPageOnWire * static_cast<std::int64_t>(plan->pages().size());
    return sum;
}

}  // namespace

bool FlashWizardState::addFile(FlashFile file) {
    const auto same = std::ranges::find(files, file.path, &FlashFile::path);
    if (same != files.end()) {
        // Whom it is for was chosen for what stood in it before; a person who chose otherwise is asked again.
        *same = std::move(file);
        return true;
    }
    if (files.size() == kMostFiles) return false;
    files.push_back(std::move(file));
    return true;
}

std::vector<SharedFlashPlan> FlashWizardState::plans() const {
    std::vector<SharedFlashPlan> plans;
    for (const FlashFile& file : files) {
        SharedFlashPlan plan = file.plan();
        if (!plan || plan->pages().empty()) return {};
        plans.push_back(std::move(plan));
    }
    std::ranges::stable_sort(plans, {},
                             [](const SharedFlashPlan& plan) { return plan->target() == FlashTarget::Fpga; });
    return plans;
}

bool FlashWizardState::losesBitstream() const {
    const auto all = plans();
    return all.size() == 1 && all.front()->target() == FlashTarget::Microcontroller;
}

bool FlashWizardState::isThere(int robot, const FlashPlan& plan) const {
    const FlashReview& review = reviews[static_cast<std::size_t>(robot)];
    if (review.state != FlashReview::State::Read) return false;
    if (plan.target() == FlashTarget::Microcontroller)
        return review.signatures.microcontrollerCrc == plan.signatures().microcontroller;
    // A bitstream that the robot does not name is one that it does not load.
    return review.signatures.flashCrc == plan.signatures().flash &&
           review.contents == wire::FlashContents::FpgaBitstream;
}

bool FlashWizardState::canLeaveOut(int robot) const {
    const auto all = plans();
    if (all.empty()) return false;
    // Sending the first erases the second: what follows something that is missing is sent anyway.
    return isThere(robot, *all.front());
}

std::vector<SharedFlashPlan> FlashWizardState::plansFor(int robot) const {
    auto all = plans();
    if (!reviews[static_cast<std::size_t>(robot)].leaveOut) return all;
    while (!all.empty() && isThere(robot, *all.front()))
        all.erase(all.begin());
    return all;
}

void FlashWizardState::takeReviews(const Snapshot& snapshot) {
    for (std::size_t at = 0; at < reviews.size(); ++at) {
        FlashReview& review = reviews[at];
        const ParameterState& known = snapshot.parameters[at];
        const bool answered = known.signatures && known.signaturesAt >= review.askedAt;
        if (review.state != FlashReview::State::Reading || !answered) continue;
        review.state = FlashReview::State::Read;
        review.signatures = *known.signatures;
        review.contents = known.robot ? known.robot->flash() : wire::FlashContents::NoData;
        // Of an upload that was broken off the volatile copy may say more than what the robot keeps.
        const auto& last = snapshot.flash[at];
        if (last && last->left == FlashLeft::NoData) review.contents = wire::FlashContents::NoData;
    }
}

std::optional<FlashHold> FlashWizardState::robotsHold(const Snapshot* snapshot, bool stopped) const {
    if (snapshot == nullptr) return FlashHold{Kind::NotConnected};
    if (snapshot->link != LinkState::Running) return FlashHold{Kind::LinkNotRunning};
    if (stopped) return FlashHold{Kind::Stopped};
    if (robots == 0) return FlashHold{Kind::NoRobot};
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(robots, robot)) continue;
        const FlashObstacle obstacle = obstacleOf(*snapshot, robot, options);
        // Reading signatures is what the review itself does, and says.
        const bool reviewing = step == FlashStep::Review &&
                               reviews[static_cast<std::size_t>(robot)].state != FlashReview::State::Read;
        if (obstacle == FlashObstacle::Asked && reviewing) continue;
        if (obstacle != FlashObstacle::None) return FlashHold{Kind::Robot, robot, obstacle};
    }
    return std::nullopt;
}

std::optional<FlashHold> FlashWizardState::filesHold() const {
    if (reading > 0) return FlashHold{Kind::Reading};
    if (files.empty()) return FlashHold{Kind::NoFile};
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!files[i].plan() || files[i].isBlank()) return FlashHold{Kind::File, -1, FlashObstacle::None, i};
    }
    if (files.size() == 2 && files[0].target == files[1].target) return FlashHold{Kind::SameTarget};
    return std::nullopt;
}

std::optional<FlashHold> FlashWizardState::reviewHold() const {
    bool any = false;
    bool reads = false;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(robots, robot)) continue;
        const FlashReview& review = reviews[static_cast<std::size_t>(robot)];
        if (review.state == FlashReview::State::Failed) return FlashHold{Kind::RobotUnread, robot};
        reads = reads || review.state != FlashReview::State::Read;
        any = any || !plansFor(robot).empty();
    }
    if (reads) return FlashHold{Kind::ReadingRobots};
    return any ? std::nullopt : std::optional(FlashHold{Kind::NothingToDo});
}

std::optional<FlashHold> FlashWizardState::hold(const Snapshot* snapshot, bool stopped) const {
    switch (step) {
        case FlashStep::Robots:
            return robotsHold(snapshot, stopped);
        case FlashStep::Files:
            return filesHold();
        case FlashStep::Review:
            if (auto held = robotsHold(snapshot, stopped)) return held;
            if (auto held = filesHold()) return held;
            return reviewHold();
        case FlashStep::Progress:
            return run.running() ? std::optional(FlashHold{Kind::Uploading}) : std::nullopt;
        case FlashStep::Result:
            break;
    }
    return std::nullopt;
}

Duration FlashWizardState::estimate() const {
    Duration slowest{};
    Duration slowestOnWire{};
    Duration wire{};
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(robots, robot)) continue;
        const auto plans = plansFor(robot);
        if (plans.empty()) continue;
        const Duration alone = estimateRemaining(plans, FlashProgress{}, Duration::zero());
        if (alone > slowest) {
            slowest = alone;
            slowestOnWire = onWire(plans);
        }
        wire += onWire(plans);
    }
    return slowest + (wire - slowestOnWire);
}

}  // namespace kickstand::ui
