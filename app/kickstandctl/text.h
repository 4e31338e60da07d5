#pragma once

#include <QString>

#include "core/engine/engine.h"

namespace kickstand::ctl {

// What is printed for people, in one place so that it reads the same everywhere.

/// "15.9 V", "212 V".
QString batteryText(double battery_V);
QString capacitorText(double capacitor_V);
/// "3", "0-2, 5".
QString robotsText(thunderbots::RobotMask robots);
/// "robot 3", "robots 0-2, 5".
QString robotsPhrase(thunderbots::RobotMask robots);
/// "12:04:03.118".
QString clockText(const Engine& engine, TimePoint time);
/// "12:04:03.118  robot 3  kick given to the dongle: 2400 / 0 µs".
QString eventLine(const Engine& engine, const EngineEvent& event);
/// "simulated dongle", "dongle at 1-2.3".
QString deviceText(const LinkUri& uri, const thunderbots::Snapshot& state);
/// "Robot 3 had 212 V on its capacitor: treat as live."; empty below the live mark or when nothing is known.
QString liveCapacitorText(int number, const thunderbots::RobotState& robot);

}  // namespace kickstand::ctl
