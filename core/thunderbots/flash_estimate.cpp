#include "core/thunderbots/flash_estimate.h"

#include <algorithm>

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

constexpr Duration kErase = 8s;
/// Until its own pace is known: five messages, the work, and the answer.
constexpr Duration kPage = 9ms;
constexpr Duration kByteCrc = 1us;
/// Going, booting, being found again.
constexpr Duration kReboot = 4s;
/// Copying, and the second boot.
constexpr Duration kCopy = 8s;
constexpr Duration kSignatures = 2100ms;
/// Before this many pages their pace is chance.
constexpr std::uint32_t kFewPages = 16;

Duration rebootOf(const FlashPlan& plan) {
    return plan.target() == image::FlashTarget::Microcontroller ? kReboot + kCopy : kReboot;
}

Duration atLeastZero(Duration span) {
    return std::max(span, Duration::zero());
}

/// What of the present stage is left.
Duration stageLeft(const FlashPlan& plan, const FlashProgress& progress, Duration inStage) {
    const std::uint32_t left_B = progress.total_B - std::min(progress.done_B, progress.total_B);
    switch (progress.stage) {
        case FlashStage::Erasing:
            return atLeastZero(kErase - inStage);
        case FlashStage::Writing: {
            const auto done = static_cast<std::uint32_t>(progress.done_B / wire::kFlashPageBytes);
            const Duration page = done < kFewPages ? kPage : inStage / done;
            return page * (left_B / wire::kFlashPageBytes);
        }
        case FlashStage::Surveying:
        case FlashStage::Verifying:
            return kByteCrc * left_B;
        case FlashStage::Rebooting:
            return atLeastZero(rebootOf(plan) - inStage);
        case FlashStage::Confirming:
            return kSignatures;
        default:
            return Duration::zero();
    }
}

/// What the stages after `stage` take.
Duration stagesAfter(const FlashPlan& plan, FlashStage stage) {
    Duration sum{};
    if (stage < FlashStage::Erasing && stage != FlashStage::Surveying) sum += kErase;
    if (stage < FlashStage::Writing) sum += kPage * static_cast<std::int64_t>(plan.pages().size());
    if (stage < FlashStage::Verifying) sum += kByteCrc * plan.extent();
    if (stage < FlashStage::Rebooting) sum += rebootOf(plan);
    if (stage < FlashStage::Confirming) sum += kSignatures;
    return sum;
}

}  // namespace

Duration estimateRemaining(const std::vector<SharedFlashPlan>& plans, const FlashProgress& progress,
                           Duration inStage) {
    if (!progress.running()) return Duration::zero();
    const FlashPlan& plan = *plans[progress.image];
    Duration sum = stageLeft(plan, progress, inStage) + stagesAfter(plan, progress.stage);
    for (std::size_t next = progress.image + 1; next < plans.size(); ++next)
        sum += stagesAfter(*plans[next], FlashStage::Reading);
    return sum;
}

}  // namespace kickstand::thunderbots
