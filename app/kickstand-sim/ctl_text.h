#pragma once

#include <QJsonObject>

#include "app/kickstandctl/output.h"

namespace kickstand::sim {

// Answers of a simulator as a person reads them.

/// What there is to do.
void printActions(ctl::Output& output, const QJsonObject& answer);
/// "robot 3: ball 1".
void printDone(ctl::Output& output, const QJsonObject& answer, const QString& unitName);
/// What a Thunderbots simulator shows: a line a robot, or everything about the one that was asked for.
void printThunderbots(ctl::Output& output, const QJsonObject& answer, bool oneRobot);

}  // namespace kickstand::sim
