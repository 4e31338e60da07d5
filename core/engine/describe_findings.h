#pragma once

#include "core/engine/describe.h"
#include "core/engine/diagnosis.h"

namespace kickstand {

// The words for what the doctor finds. Any thread once the application object exists.

/// What was found, and what to do about it.
Description describe(const Finding& finding);
/// What is looked at, in a word or two: "Emergency stop".
QString describe(Check check);
/// "ok", "look", "wrong", "unknown".
QString describe(CheckState state);
/// "robot 3", "robots 0-2, 5".
QString describeRobots(thunderbots::RobotMask robots);

}  // namespace kickstand
