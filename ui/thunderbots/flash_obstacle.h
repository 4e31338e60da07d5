#pragma once

#include <vector>

#include "core/thunderbots/commands.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// What keeps a robot from being flashed, in the order in which it is to be seen to.
enum class FlashObstacle {
    None,
    NotHeard,
    Uploading,
    Wheels,
    Dribbler,
    Charger,
    Autokick,
    Discharging,
    Sweeping,
    Checking,
    CapacitorLive,
    CapacitorUnknown,  ///< Last known to be charged, and not measured any more.
    Armed,
    BatteryLow,
    Uncommitted,  ///< Applied parameters that an erase would lose.
    Asked,        ///< Something else asks it something.
};

/// The first thing that keeps a robot from being flashed. The engine judges again when it is asked to begin.
FlashObstacle obstacleOf(const thunderbots::Snapshot& snapshot, int robot,
                         const thunderbots::FlashOptions& options);

/// Whether its battery is so low that an upload is advised against.
bool isFlashBatteryLow(const thunderbots::RobotState& robot);
/// Whether its capacitor was last known to be charged, and nobody measures it any more.
bool isFlashCapacitorUnknown(const thunderbots::RobotState& robot);

/// What does away with an obstacle, in this order; empty where no command does.
std::vector<thunderbots::Command> remedyOf(FlashObstacle obstacle, int robot);

}  // namespace kickstand::ui
