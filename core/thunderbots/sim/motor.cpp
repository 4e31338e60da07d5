#include "core/thunderbots/sim/motor.h"

#include <array>
#include <cmath>

namespace kickstand::thunderbots::sim {
namespace {

constexpr double kSpinUp_s = 0.06;
constexpr double kBraking_s = 0.02;
// The wire's speeds are per 5 ms.
constexpr double kPeriod_s = 0.005;
// Eight pole pairs: 48 steps of the Hall sensors in the 1440 quarter-degrees of a turn.
constexpr std::int64_t kCountsPerHallStep = 30;

}  // namespace

void Motor::step(Duration span, double target, bool driven) {
    if (!driven) target = 0;
    const double lag_s = driven ? kSpinUp_s : kBraking_s;
    const double left = std::exp(-seconds(span) / lag_s);
    const double excess = speed_ - target;
    position_ += (target * seconds(span) + excess * lag_s * (1 - left)) / kPeriod_s;
    speed_ = target + excess * left;
}

std::int64_t Motor::count() const {
    return static_cast<std::int64_t>(std::floor(position_));
}

std::uint8_t Motor::encoderLines() const {
    const auto phase = static_cast<std::uint8_t>(count() & 3);
    return static_cast<std::uint8_t>(phase ^ phase >> 1);
}

std::uint8_t Motor::hallLines() const {
    static constexpr std::array<std::uint8_t, 6> kSteps{1, 3, 2, 6, 4, 5};
    const std::int64_t step = static_cast<std::int64_t>(
        std::floor(static_cast<double>(count()) / static_cast<double>(kCountsPerHallStep)));
    return kSteps[static_cast<std::size_t>((step % 6 + 6) % 6)];
}

}  // namespace kickstand::thunderbots::sim
