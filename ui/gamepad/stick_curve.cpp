#include "ui/gamepad/stick_curve.h"

#include <algorithm>
#include <cmath>

namespace kickstand::ui {

namespace {

constexpr double kWidestDeadZone = 0.9;

}  // namespace

double shaped(double position, const StickCurve& curve) {
    if (!std::isfinite(position)) return 0;
    const double dead = std::clamp(curve.deadZone, 0.0, kWidestDeadZone);
    const double bend = std::clamp(curve.bend, 0.0, 1.0);
    const double way = std::min(std::abs(position), 1.0);
    if (way <= dead) return 0;
    const double part = (way - dead) / (1 - dead);
    return std::copysign((1 - bend) * part + bend * part * part * part, position);
}

}  // namespace kickstand::ui
