#include "core/thunderbots/sim/sim_world.h"

#include <algorithm>

namespace kickstand::thunderbots::sim {
namespace {

// One robot in the set wants charging; the others differ a little, in no visible order.
constexpr std::uint8_t kLowRobot = 5;
constexpr double kLowBattery_V = 14.2;
constexpr double kFullBattery_V = 16.4;
constexpr double kBatteryStep_V = 0.075;

double batteryOf(std::uint8_t robot) {
    if (robot == kLowRobot) return kLowBattery_V;
    return kFullBattery_V - kBatteryStep_V * (robot * 7 % wire::kRobotCount);
}

}  // namespace

SimWorld::SimWorld(Scheduler& scheduler, const ThunderbotsSimOptions& options)
    : medium_(options.weather, options.seed) {
    const unsigned set = options.cableRobot ? 1U << *options.cableRobot : options.robots;
    for (std::uint8_t number = 0; number < wire::kRobotCount; ++number) {
        if ((set >> number & 1) == 0) continue;
        units_.push_back(number);
        robots_.push_back(
            std::make_unique<RobotSim>(scheduler, RobotSettings{.number = number,
                                                                .battery_V = batteryOf(number),
                                                                .channels = {},
                                                                .seed = options.seed + 1 + number,
                                                                .noise = options.noise}));
        radios_.emplace_back(*robots_.back());
    }
    if (options.cableRobot) {
        cable_ = std::make_unique<CableSim>(scheduler, *robots_.front());
    } else {
        dongle_ = std::make_unique<DongleSim>(
            scheduler, medium_, radios_,
            DongleSettings{.pace = options.pace, .channels = options.dongleChannels});
    }
}

RobotSim* SimWorld::robot(int unit) const {
    const auto found = std::ranges::find(units_, unit);
    return found == units_.end() ? nullptr : robots_[static_cast<std::size_t>(found - units_.begin())].get();
}

}  // namespace kickstand::thunderbots::sim
