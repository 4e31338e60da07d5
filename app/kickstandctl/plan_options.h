#pragma once

#include <optional>
#include <vector>

#include "app/kickstandctl/command.h"
#include "core/motionplan/plan.h"

namespace kickstand::ctl {

// What the motionplan commands read from their command line. Everything wrong is exit 2.

/// --slot, 0-4.
Expected<int> readSlot(const Invocation& invocation);
/// --plan, 1-254; none where it was not given.
Expected<std::optional<int>> readPlanId(const Invocation& invocation);
/// The plan in the operands or in --file, checked to be one that the robot knows; none where neither was
/// given.
Expected<std::optional<std::vector<motionplan::Movement>>> readPlan(const Invocation& invocation,
                                                                    motionplan::PlanUse use);
/// --wheels and --change.
struct SpeedChange {
    motionplan::Wheels wheels = motionplan::Wheels::BothForward;
    int change_percent = 0;
};
Expected<SpeedChange> readSpeedChange(const Invocation& invocation);

}  // namespace kickstand::ctl
