#pragma once

#include <span>

#include "app/kickstandctl/command.h"

namespace kickstand::ctl {

// The commands, a family a file. commands() joins them.
std::span<const CommandSpec> deviceCommands();
std::span<const CommandSpec> codecCommands();
std::span<const CommandSpec> doctorCommands();
std::span<const CommandSpec> stopCommands();
std::span<const CommandSpec> thunderbotsWatchCommands();
std::span<const CommandSpec> thunderbotsDriveCommands();
std::span<const CommandSpec> thunderbotsKickCommands();
std::span<const CommandSpec> thunderbotsSweepCommands();
std::span<const CommandSpec> thunderbotsCheckCommands();
std::span<const CommandSpec> thunderbotsFlashCommands();
std::span<const CommandSpec> thunderbotsSetupCommands();
std::span<const CommandSpec> thunderbotsParametersCommands();
std::span<const CommandSpec> smartDeviceCommands();
std::span<const CommandSpec> motionplanCommands();
std::span<const CommandSpec> motionplanRunCommands();
std::span<const CommandSpec> coachCommands();
std::span<const CommandSpec> coachRadioCommands();

}  // namespace kickstand::ctl
