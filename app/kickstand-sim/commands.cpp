#include "app/kickstand-sim/families.h"

namespace kickstand::sim {

std::span<const CommandSpec> commands() {
    static const std::vector<CommandSpec> kAll{thunderbotsCommand(), smartDeviceCommand(),
                                               motionplanCommand(), coachCommand(), ctlCommand()};
    return kAll;
}

}  // namespace kickstand::sim
