#pragma once

#include <vector>

#include "core/thunderbots/flash_plan.h"
#include "core/thunderbots/flash_progress.h"

namespace kickstand::thunderbots {

/// How long an upload will still take, after `inStage` of its present stage: what the robot needs for each
/// step (protocol 6.7), and a page as long as the pages before it took. Any thread.
Duration estimateRemaining(const std::vector<SharedFlashPlan>& plans, const FlashProgress& progress,
                           Duration inStage);

}  // namespace kickstand::thunderbots
