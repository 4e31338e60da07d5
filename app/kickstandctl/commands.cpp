#include <vector>

#include "app/kickstandctl/families.h"

namespace kickstand::ctl {

std::span<const CommandSpec> commands() {
    static const std::vector<CommandSpec> kAll = [] {
        std::vector<CommandSpec> all;
        for (const auto family :
             {deviceCommands(), doctorCommands(), stopCommands(), codecCommands(), thunderbotsWatchCommands(),
              thunderbotsDriveCommands(), thunderbotsKickCommands(), thunderbotsSweepCommands(),
              thunderbotsCheckCommands(), thunderbotsSetupCommands(), thunderbotsFlashCommands(),
              thunderbotsParametersCommands(), smartDeviceCommands(), motionplanCommands(),
              motionplanRunCommands(), coachCommands(), coachRadioCommands()})
            all.insert(all.end(), family.begin(), family.end());
        return all;
    }();
    return kAll;
}

}  // namespace kickstand::ctl
