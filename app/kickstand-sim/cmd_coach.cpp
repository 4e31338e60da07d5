#include <QString>
#include <array>

#include "app/kickstand-sim/coach_simulation.h"
#include "app/kickstand-sim/common_options.h"
#include "app/kickstand-sim/families.h"
#include "app/kickstand-sim/pty_serving.h"
#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

using coach::sim::CoachSimOptions;

/// Options of the simulation, under the names that they have in a sim:coach link as well.
constexpr std::array kSimOptions{"--address", "--fresh", "--towrps", "--coaches",
                                 "--loss",    "--lossy", "--seed",   "--fall"};

ctl::Expected<CoachSimOptions> readSimulation(const Invocation& invocation) {
    LinkUri uri{.scheme = "sim", .target = "coach", .options = {}};
    for (const std::string_view option : kSimOptions) {
        if (!invocation.has(option)) continue;
        const bool isSwitch = option == "--fresh";
        uri.options[std::string(option.substr(2))] = isSwitch ? "1" : std::string(invocation.text(option));
    }
    auto options = coach::sim::parseSimOptions(uri);
    if (!options) return ctl::refusedInput(options.error());
    return *options;
}

/// As many paths as there are modules.
ctl::Expected<std::vector<std::string>> readPaths(const Invocation& invocation, std::size_t modules) {
    auto paths = readPtyPaths(invocation);
    if (!paths || paths->size() == modules) return paths;
    return ctl::badUsage(
        Words::tr("There are radio modules: %1, and paths for them: %2.").arg(modules).arg(paths->size()),
        Words::tr("Give --pty a path for each address, with commas between them."));
}

ctl::Outcome run(const Invocation& invocation) {
    const auto simulated = readSimulation(invocation);
    if (!simulated) return tl::unexpected(simulated.error());
    const auto paths = readPaths(invocation, simulated->modules.size());
    if (!paths) return tl::unexpected(paths.error());
    const QString link = QStringLiteral("?protocol=coach&baud=9600");
    return servePtysUntilTold(invocation, link, [&](Scheduler& scheduler) {
        auto simulation = std::make_unique<CoachSimulation>(scheduler, *simulated);
        std::vector<ServedLine> lines;
        for (std::size_t i = 0; i < paths->size(); ++i)
            lines.push_back({&simulation->sim().module(i), (*paths)[i]});
        return PtySimulation{std::move(simulation), std::move(lines)};
    });
}

constexpr std::array kOptions{
    OptionSpec{"--pty", "PATH,…",
               QT_TRANSLATE_NOOP("kickstand_sim", "where the serial ports are to be: one for each module")},
    OptionSpec{
        "--address", "LIST",
        QT_TRANSLATE_NOOP("kickstand_sim", "the modules' addresses, as in 0xBC05,0xAF05; 0xBC05 without it")},
    OptionSpec{"--fresh", "",
               QT_TRANSLATE_NOOP("kickstand_sim", "the modules are as they come from the factory")},
    OptionSpec{"--towrps", "LIST",
               QT_TRANSLATE_NOOP("kickstand_sim", "the teams of the boats; 3,5,7 without it")},
    OptionSpec{"--coaches", "LIST",
               QT_TRANSLATE_NOOP("kickstand_sim", "the teams of simulated COACHes; none without it")},
    OptionSpec{"--loss", "P",
               QT_TRANSLATE_NOOP("kickstand_sim", "which part of the radio packets is lost, 0 to 1")},
    OptionSpec{
        "--lossy", "LIST",
        QT_TRANSLATE_NOOP("kickstand_sim",
                          "boats with a bad radio, and which part of their packets is lost, as in 7:0.3")},
    kSeedOption,
    OptionSpec{
        "--fall", "SECONDS",
        QT_TRANSLATE_NOOP("kickstand_sim", "how often a crew's morale falls; 5 without it, 0 for never")},
    kControlOption,
    kJsonOption,
};

}  // namespace

CommandSpec coachCommand() {
    return {"coach",
            "",
            0,
            QT_TRANSLATE_NOOP("kickstand_sim",
                              "Serves simulated XBee modules, with TOWRPs and COACHes that they hear."),
            kServingDetails,
            kOptions,
            "coach --pty /tmp/xbee --towrps 3,5",
            run};
}

}  // namespace kickstand::sim
