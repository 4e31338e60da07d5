#pragma once

#include <QString>

#include "app/kickstand-sim/command.h"

namespace kickstand::sim {

/// Help on a command, or on the program where it is null.
QString helpText(const CommandSpec* command);

/// "kickstand-sim 0.1.0".
QString versionText();

}  // namespace kickstand::sim
