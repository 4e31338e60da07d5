#pragma once

#include <array>
#include <optional>

#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// How several robots stand with one thing.
enum class All { None, Some, Every };

/// What the chosen robots have in common: what a panel shows of them. A pure function of the snapshot.
struct ChoiceSummary {
    thunderbots::RobotMask chosen = 0;
    thunderbots::RobotMask live = 0;  ///< Those of them that are heard: the ones that commands are for.
    /// The set point that they share, wheel by wheel; none where they differ.
    std::array<std::optional<int>, thunderbots::kWheels> target{};
    std::array<int, thunderbots::kWheels> reached{};  ///< Of the first live one.
    bool mustPassZero = false;                        ///< Any of them.
    All run = All::None;
    All dribbler = All::None;
    All armed = All::None;
    All charger = All::None;
    All discharging = All::None;
    /// The highest capacitor voltage of those chosen, live or remembered, and whose it is.
    std::optional<double> capacitor_V;
    int capacitorRobot = -1;
    bool capacitorStale = false;
    TimePoint capacitorSeen{};  ///< When a stale one was last current.
    /// What they were told, where it is the same for all of those that are heard.
    std::optional<thunderbots::wire::DriveBlock> told;
    bool toldDiffers = false;
};

ChoiceSummary summarize(const thunderbots::Snapshot& snapshot, thunderbots::RobotMask chosen);

}  // namespace kickstand::ui
