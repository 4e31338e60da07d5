#include "core/motionplan/path.h"

#include <cmath>
#include <numbers>

namespace kickstand::motionplan {
namespace {

constexpr double kHalfCircle_deg = 180;

double radians(double angle_deg) {
    return angle_deg * std::numbers::pi / kHalfCircle_deg;
}

/// A point beside the robot's middle: `distance_cm` to its left.
Pose beside(const Pose& pose, double distance_cm) {
    const double heading = radians(pose.heading_deg);
    return {pose.x_cm - distance_cm * std::cos(heading), pose.y_cm - distance_cm * std::sin(heading),
            pose.heading_deg};
}

}  // namespace

Pose along(const Pose& start, const wire::Movement& movement, double fraction, double track_cm) {
    const double part = movement.amount * fraction;
    if (!wire::isTurn(movement.wheels)) {
        const double way_cm = wire::isBack(movement.wheels) ? -part : part;
        const double heading = radians(start.heading_deg);
        return {start.x_cm - way_cm * std::sin(heading), start.y_cm + way_cm * std::cos(heading),
                start.heading_deg};
    }
    const bool rightStands =
        movement.wheels == wire::Wheels::LeftForward || movement.wheels == wire::Wheels::LeftBack;
    const double toStanding_cm = rightStands ? -track_cm / 2 : track_cm / 2;
    Pose standing = beside(start, toStanding_cm);
    standing.heading_deg += wire::turnsLeft(movement.wheels) ? part : -part;
    return beside(standing, -toStanding_cm);
}

std::vector<Pose> corners(std::span<const wire::Movement> movements, double track_cm) {
    std::vector<Pose> poses{{}};
    poses.reserve(movements.size() + 1);
    for (const wire::Movement& movement : movements)
        poses.push_back(along(poses.back(), movement, 1, track_cm));
    return poses;
}

}  // namespace kickstand::motionplan
