#include <QString>
#include <array>

#include "app/kickstand-sim/common_options.h"
#include "app/kickstand-sim/families.h"
#include "app/kickstand-sim/nxt_simulation.h"
#include "app/kickstand-sim/pty_serving.h"
#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

/// Options of the simulation, under the names that they have in a sim:motionplan link as well.
constexpr std::array<std::pair<const char*, const char*>, 7> kSimOptions{{{"--loss", "loss"},
                                                                          {"--reply-loss", "reply-loss"},
                                                                          {"--duplicate", "duplicate"},
                                                                          {"--delay", "delay_ms"},
                                                                          {"--seed", "seed"},
                                                                          {"--pace", "pace"},
                                                                          {"--text", "text"}}};

ctl::Expected<motionplan::sim::NxtOptions> readSimulation(const Invocation& invocation) {
    std::map<std::string, std::string> given;
    for (const auto& [option, name] : kSimOptions) {
        if (invocation.has(option)) given[name] = invocation.text(option);
    }
    if (invocation.has("--text")) given["text"] = "on";
    auto options = motionplan::sim::parseNxtOptions(given);
    if (!options) return ctl::refusedInput(options.error());
    return *options;
}

ctl::Outcome run(const Invocation& invocation) {
    const auto simulated = readSimulation(invocation);
    if (!simulated) return tl::unexpected(simulated.error());
    const auto path = readPtyPath(invocation);
    if (!path) return tl::unexpected(path.error());
    return servePtysUntilTold(invocation, QStringLiteral("?protocol=motionplan"), [&](Scheduler& scheduler) {
        auto simulation = std::make_unique<NxtSimulation>(scheduler, *simulated);
        std::vector<ServedLine> lines{{&simulation->device(), *path}};
        return PtySimulation{std::move(simulation), std::move(lines)};
    });
}

constexpr std::array kOptions{
    OptionSpec{"--pty", "PATH", QT_TRANSLATE_NOOP("kickstand_sim", "where the serial port is to be")},
    OptionSpec{"--loss", "P",
               QT_TRANSLATE_NOOP("kickstand_sim", "which part of the messages is lost, 0 to 1")},
    OptionSpec{"--reply-loss", "P",
               QT_TRANSLATE_NOOP("kickstand_sim", "which part of the reads is never answered, 0 to 1")},
    OptionSpec{"--duplicate", "P",
               QT_TRANSLATE_NOOP("kickstand_sim", "which part of the robot's messages comes twice, 0 to 1")},
    OptionSpec{"--delay", "MS",
               QT_TRANSLATE_NOOP("kickstand_sim", "by how much the robot's messages come later")},
    OptionSpec{"--pace", "N", QT_TRANSLATE_NOOP("kickstand_sim", "how much faster than real it moves")},
    OptionSpec{"--text", "",
               QT_TRANSLATE_NOOP("kickstand_sim",
                                 "its program reads mailboxes as text: what follows a zero byte is lost")},
    kSeedOption,
    kControlOption,
    kJsonOption,
};

}  // namespace

CommandSpec motionplanCommand() {
    return {"motionplan",
            "",
            0,
            QT_TRANSLATE_NOOP("kickstand_sim", "Serves a simulated NXT that takes motion plans."),
            kServingDetails,
            kOptions,
            "motionplan --pty /tmp/nxt",
            run};
}

}  // namespace kickstand::sim
