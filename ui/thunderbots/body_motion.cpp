#include "ui/thunderbots/body_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kickstand::ui {

using namespace thunderbots;

namespace {

// Quarter-degrees per 5 ms for 1 m/s or 1 rad/s of each wheel (protocol 6.6).
constexpr double kFrontX = 42.5995;
constexpr double kBackX = 35.9169;
constexpr double kFrontY = 27.6645;
constexpr double kBackY = 35.9169;
constexpr double kTurn = 4.3175;

struct Row {
    double x;
    double y;
    double turn;
};
constexpr std::array<Row, kWheels> kRows{{
    {-kFrontX, kFrontY, kTurn},
    {-kBackX, -kBackY, kTurn},
    {kBackX, -kBackY, kTurn},
    {kFrontX, kFrontY, kTurn},
}};

double speedOf(const Row& row, const BodyMotion& motion) {
    return row.x * motion.x_m_per_s + row.y * motion.y_m_per_s + row.turn * motion.turn_rad_per_s;
}

}  // namespace

BodyMotion operator*(const BodyMotion& motion, double factor) {
    return {motion.x_m_per_s * factor, motion.y_m_per_s * factor, motion.turn_rad_per_s * factor};
}

MadeWheels wheelsOf(const BodyMotion& motion, int limit) {
    MadeWheels made;
    std::array<double, kWheels> speeds{};
    double fastest = 0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        speeds.at(i) = speedOf(kRows.at(i), motion);
        if (!std::isfinite(speeds.at(i))) return made;
        fastest = std::max(fastest, std::abs(speeds.at(i)));
    }
    // What rounds to the limit is within it.
    if (fastest >= limit + 0.5) made.scale = limit / fastest;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        made.wheels.at(i) = static_cast<int>(std::lround(speeds.at(i) * made.scale));
    return made;
}

BodyMotion motionOf(const WheelSpeeds& wheels) {
    // The least squares of four equations for three unknowns. The column of x is at right angles to the other
    // two, which leaves two equations for y and the turn.
    double xx = 0;
    double yy = 0;
    double tt = 0;
    double yt = 0;
    double xw = 0;
    double yw = 0;
    double tw = 0;
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        const Row& row = kRows.at(i);
        const double wheel = wheels.at(i);
        xx += row.x * row.x;
        yy += row.y * row.y;
        tt += row.turn * row.turn;
        yt += row.y * row.turn;
        xw += row.x * wheel;
        yw += row.y * wheel;
        tw += row.turn * wheel;
    }
    const double determinant = yy * tt - yt * yt;
    return {xw / xx, (yw * tt - tw * yt) / determinant, (tw * yy - yw * yt) / determinant};
}

BodyMotion fastestMotion(int limit) {
    return {limit / std::max(kFrontX, kBackX), limit / std::max(kFrontY, kBackY), limit / kTurn};
}

}  // namespace kickstand::ui
