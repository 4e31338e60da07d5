#pragma once

#include "app/kickstand-sim/command.h"

namespace kickstand::sim {

/// Understands a command line (without the program's own name). An option's value follows it or its "=";
/// "--" ends the options, and what begins with a minus and a digit is none. Everything wrong is exit 2.
ctl::Expected<Invocation> parseArguments(std::span<const std::string> arguments);

}  // namespace kickstand::sim
