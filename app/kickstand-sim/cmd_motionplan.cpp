#include <QString>
#include <array>
#include <filesystem>

#include "app/kickstand-sim/families.h"
#include "app/kickstand-sim/nxt_simulation.h"
#include "app/kickstand-sim/pty_carrier.h"
#include "app/kickstand-sim/serving.h"
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
    if (invocation.text("--pty").empty())
        return ctl::badUsage(Words::tr("Nothing says where the serial port is to be."),
                             Words::tr("Add --pty PATH."));
    std::error_code error;
    const std::string path = std::filesystem::absolute(std::string(invocation.text("--pty")), error).string();
    return serveUntilTold(invocation, [&](Scheduler& scheduler, Log&) -> ctl::Expected<Served> {
        auto simulation = std::make_unique<NxtSimulation>(scheduler, *simulated);
        auto carrier = PtyCarrier::serve(scheduler, {{&simulation->device(), path}},
                                         QStringLiteral("?protocol=motionplan"));
        if (!carrier) return tl::unexpected(carrier.error());
        return Served{std::move(simulation), std::move(*carrier)};
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
    OptionSpec{
        "--seed", "N",
        QT_TRANSLATE_NOOP("kickstand_sim", "of all that happens by chance: the same seed, the same chances")},
    OptionSpec{"--control", "PATH",
               QT_TRANSLATE_NOOP("kickstand_sim",
                                 "the control socket; $XDG_RUNTIME_DIR/kickstand-sim.sock without it")},
    OptionSpec{"--json", "", QT_TRANSLATE_NOOP("kickstand_sim", "what is said as JSON, a value a line")},
};

}  // namespace

CommandSpec motionplanCommand() {
    return {"motionplan",
            "",
            0,
            QT_TRANSLATE_NOOP("kickstand_sim", "Serves a simulated NXT that takes motion plans."),
            QT_TRANSLATE_NOOP("kickstand_sim",
                              "It says how to reach it, and goes on until Ctrl+C, SIGTERM or SIGHUP."),
            kOptions,
            "motionplan --pty /tmp/nxt",
            run};
}

}  // namespace kickstand::sim
