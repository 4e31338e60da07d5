#pragma once

#include "app/kickstand-sim/command.h"

namespace kickstand::sim {

// The commands, each in its file. commands() joins them.
CommandSpec thunderbotsCommand();
CommandSpec smartDeviceCommand();
CommandSpec motionplanCommand();
CommandSpec coachCommand();
CommandSpec ctlCommand();

}  // namespace kickstand::sim
