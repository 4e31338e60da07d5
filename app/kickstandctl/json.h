#pragma once

#include <QJsonArray>
#include <QJsonObject>

#include "app/kickstandctl/failure.h"
#include "core/engine/engine.h"

namespace kickstand::ctl {

// The shapes of what --json prints. Names are stable; numbers are in the unit that their name ends with.

/// Volts and degrees with the digits that a reading really has.
double rounded(double value);
/// "not-heard", "waiting", "current", "stale".
QString name(thunderbots::Freshness freshness);
/// UTC with milliseconds: "2024-05-01T12:04:03.118Z".
QString isoTime(const Engine& engine, TimePoint time);

/// {"code", "what", "remedy"}, and "command" where the remedy has one.
QJsonObject toJson(const Failure& failure);
QJsonObject toJson(const Error& error);
QJsonObject toJson(const FoundDevice& device);
/// One robot: its number, whether it is heard, and its readings or null.
QJsonObject robotToJson(int number, const thunderbots::RobotState& robot, TimePoint now);
/// The link, the dongle and its e-stop, radios and channels; not the robots.
QJsonObject linkToJson(const LinkUri& uri, const thunderbots::Snapshot& state);
/// {"type": "event", "time", "event", "robot", "text"}.
QJsonObject toJson(const Engine& engine, const EngineEvent& event);
/// The numbers of the robots, ascending.
QJsonArray toJson(thunderbots::RobotMask robots);

}  // namespace kickstand::ctl
