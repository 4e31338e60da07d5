#pragma once

#include <cstdint>
#include <string_view>

#include "app/kickstandctl/failure.h"
#include "core/base/time.h"
#include "core/thunderbots/types.h"

namespace kickstand::ctl {

// Numbers as people type them. Strict and the same in every locale: the whole text has to be the number.
// `what` is what the text was given for ("--robot"). Everything wrong is exit 2, with the range.

/// A whole number, decimal or 0x hexadecimal.
Expected<int> parseWhole(std::string_view text, std::string_view what, int lowest, int highest);
/// A number with a decimal point.
Expected<double> parseDecimal(std::string_view text, std::string_view what, double lowest, double highest);
/// A time in seconds, from a hundredth to a day.
Expected<Duration> parseSeconds(std::string_view text, std::string_view what);
/// One robot, 0-15.
Expected<int> parseRobot(std::string_view text);
/// Robots: "3", "0,3", "5-7", "0,5-7".
Expected<thunderbots::RobotMask> parseRobots(std::string_view text);
/// Four speeds, "40,-36,36,0", each within ±`limit`.
Expected<thunderbots::WheelSpeeds> parseWheels(std::string_view text, int limit);

}  // namespace kickstand::ctl
