#pragma once

#include "app/kickstandctl/command.h"

namespace kickstand::ctl {

/// Understands a command line (without the program's own name). Global options may stand anywhere; an
/// option's value follows it or its "="; "--" ends the options. Everything wrong is exit 2, with the nearest
/// right word.
Expected<Invocation> parseArguments(std::span<const std::string> arguments);

/// The one of `choices` that somebody who typed `text` most likely meant; empty when none is near.
std::string nearest(std::string_view text, std::span<const std::string> choices);

}  // namespace kickstand::ctl
