#pragma once

#include <QJsonObject>

#include "app/kickstandctl/failure.h"
#include "core/link/link_uri.h"
#include "core/motionplan/snapshot.h"

namespace kickstand::ctl {

class Output;
class SessionRunner;

/// Everything that is known of the robot: its link, its slots, its trigger plan, what it executes.
QJsonObject robotToJson(const LinkUri& uri, const motionplan::Snapshot& state);
/// The same as the one value of a command, and as text.
void showRobot(Output& output, const LinkUri& uri, const motionplan::Snapshot& state);

/// Connects, and waits until the robot has answered.
Outcome beginMotionplan(SessionRunner& runner);

}  // namespace kickstand::ctl
