#pragma once

#include <span>
#include <vector>

#include "core/motionplan/wire/movement.h"

namespace kickstand::motionplan {

/// The distance between the wheels, for drawing, where nobody has said another one.
inline constexpr double kTrackWidth_cm = 11;

/// Where a robot's middle is and where its nose points: x to the right, y ahead of its first place; heading
/// counted from y, to the left.
struct Pose {
    double x_cm = 0;
    double y_cm = 0;
    double heading_deg = 0;
};

/// Where a robot comes to that has done `fraction` (0-1) of a movement from `start`. A straight movement goes
/// along the heading; a turn goes about the wheel that stands (protocol 5.1). Any thread.
Pose along(const Pose& start, const wire::Movement& movement, double fraction, double track_cm);

/// The poses between the movements of a plan: one more than there are movements. Any thread.
std::vector<Pose> corners(std::span<const wire::Movement> movements, double track_cm);

}  // namespace kickstand::motionplan
