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

/// What the robot does when this program lets go of the line, as a member of a command's JSON: the ID of the
/// trigger plan that it starts then, null for none; without the member where that is not known.
void addClosing(QJsonObject& json, const motionplan::Snapshot& state);
/// The same as a sentence; empty where it does nothing.
QString closingText(const motionplan::Snapshot& state);

/// Connects, and waits until the robot has answered.
Outcome beginMotionplan(SessionRunner& runner);
/// Asks a robot that answers for its trigger plan, where that is not known. No answer leaves it so.
void askForTrigger(SessionRunner& runner);
/// Sends Stop at once, whether anything executes or not, and asks for the trigger plan then. What is known
/// afterwards; whether Stop was confirmed the end of the run tells.
motionplan::Snapshot stopAndAsk(SessionRunner& runner);

}  // namespace kickstand::ctl
