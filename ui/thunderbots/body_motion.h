#pragma once

#include "core/thunderbots/types.h"

namespace kickstand::ui {

/// How a robot's body is to move: x forward, y to its left, turning counter-clockwise (protocol 6.6).
struct BodyMotion {
    double x_m_per_s = 0;
    double y_m_per_s = 0;
    double turn_rad_per_s = 0;

    friend bool operator==(const BodyMotion&, const BodyMotion&) = default;
};

BodyMotion operator*(const BodyMotion& motion, double factor);

/// The wheels that a motion makes.
struct MadeWheels {
    thunderbots::WheelSpeeds wheels{};
    /// 1, or the part of the motion that its fastest wheel had to be slowed down to. The direction stays.
    double scale = 1;
};

/// The wheel set points of a motion, none past ±`limit` (protocol 6.6). What is no number stands still. Pure.
MadeWheels wheelsOf(const BodyMotion& motion, int limit);

/// The motion that comes nearest to these wheels; wheels that pull against each other make none. Pure.
BodyMotion motionOf(const thunderbots::WheelSpeeds& wheels);

/// How fast the body goes along each of the three alone when no wheel is past ±`limit`. Pure.
BodyMotion fastestMotion(int limit);

}  // namespace kickstand::ui
