#include "ui/thunderbots/flash_obstacle.h"

#include "core/thunderbots/wire/readings.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

/// What it is up to, if anything.
FlashObstacle unrestOf(const RobotIntent& intent) {
    if (intent.run) return FlashObstacle::Wheels;
    if (intent.dribbler) return FlashObstacle::Dribbler;
    if (intent.discharging) return FlashObstacle::Discharging;
    if (intent.sweeping) return FlashObstacle::Sweeping;
    if (intent.checking) return FlashObstacle::Checking;
    if (intent.charger) return FlashObstacle::Charger;
    return intent.autokick ? FlashObstacle::Autokick : FlashObstacle::None;
}

bool isCharged(const RobotState& robot) {
    return robot.capacitor && robot.capacitor->last_V >= wire::kCapacitorLive_V;
}

}  // namespace

bool isFlashBatteryLow(const RobotState& robot) {
    return robot.freshness == Freshness::Current && robot.readings.battery_V < wire::kBatteryEmpty_V;
}

bool isFlashCapacitorUnknown(const RobotState& robot) {
    return robot.freshness != Freshness::Current && (!robot.capacitor || isCharged(robot));
}

FlashObstacle obstacleOf(const Snapshot& snapshot, int robot, const FlashOptions& options) {
    const auto at = static_cast<std::size_t>(robot);
    const RobotState& state = snapshot.robots[at];
    const RobotIntent& intent = snapshot.intents[at];
    const auto& flash = snapshot.flash[at];
    if (flash && flash->running()) return FlashObstacle::Uploading;
    if (!state.live) return FlashObstacle::NotHeard;
    if (const FlashObstacle unrest = unrestOf(intent); unrest != FlashObstacle::None) return unrest;
    if (isFlashCapacitorUnknown(state)) {
        if (!options.capacitorUnknown) return FlashObstacle::CapacitorUnknown;
    } else if (isCharged(state)) {
        return FlashObstacle::CapacitorLive;
    }
    if (intent.highVoltageArmed) return FlashObstacle::Armed;
    if (isFlashBatteryLow(state) && !options.lowBattery) return FlashObstacle::BatteryLow;
    if (snapshot.parameters[at].standing == ParameterStanding::Applied) return FlashObstacle::Uncommitted;
    return snapshot.requests[at].op ? FlashObstacle::Asked : FlashObstacle::None;
}

std::vector<Command> remedyOf(FlashObstacle obstacle, int robot) {
    const RobotMask robots = maskOf(robot);
    switch (obstacle) {
        case FlashObstacle::Wheels:
            return {Brake{robots}};
        case FlashObstacle::Dribbler:
            return {SetDribbler{robots, false}};
        case FlashObstacle::Charger:
            return {SetCharger{robots, false}};
        case FlashObstacle::Autokick:
            return {SetAutokick{robots, false, {}}};
        case FlashObstacle::Sweeping:
            return {StopSweep{}};
        case FlashObstacle::Checking:
            return {StopCheck{}};
        case FlashObstacle::CapacitorLive:
            return {ArmHighVoltage{robots, true}, Discharge{robot, true}};
        case FlashObstacle::Armed:
            return {ArmHighVoltage{robots, false}};
        default:
            return {};
    }
}

}  // namespace kickstand::ui
