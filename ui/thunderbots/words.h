#pragma once

#include <QString>

#include "core/base/time.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// The words that several panels use for the same things.

/// "40 s", "3 min", "2 h".
QString ageText(Duration age);
/// "15.9 V".
QString batteryText(double volts);
/// "212 V".
QString capacitorText(double volts);
/// "robot 3", "robots 0, 3–5", "all robots"; empty for none.
QString robotsText(thunderbots::RobotMask robots);
/// What a drive block tells a robot: "run · 42 −36 36 0 · dribbler".
QString toldText(const thunderbots::wire::DriveBlock& block);
/// Whether a capacitor that was last known so is to be shown as live, whatever its age.
bool isLive(const thunderbots::RobotState& robot);

}  // namespace kickstand::ui
