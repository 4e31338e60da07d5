#include <array>

#include "app/kickstand-sim/board_simulation.h"
#include "app/kickstand-sim/common_options.h"
#include "app/kickstand-sim/families.h"
#include "app/kickstand-sim/pty_serving.h"
#include "app/kickstand-sim/words.h"
#include "core/link/link_uri.h"

namespace kickstand::sim {
namespace {

/// Options of the simulation, under the names that they have in a sim:smartdevice link as well.
constexpr std::array<std::pair<const char*, const char*>, 4> kSimOptions{
    {{"--type", "devices"}, {"--boot", "boot_ms"}, {"--seed", "seed"}, {"--data", "data_bytes"}}};

ctl::Expected<smartdevice::sim::SmartDeviceSimOptions> readSimulation(const Invocation& invocation) {
    LinkUri uri{.scheme = "sim", .target = "smartdevice", .options = {{"devices", "PolarBear"}}};
    for (const auto& [option, name] : kSimOptions) {
        if (invocation.has(option)) uri.options[name] = invocation.text(option);
    }
    auto options = smartdevice::sim::parseSimOptions(uri);
    if (!options) return ctl::refusedInput(options.error());
    return *options;
}

ctl::Outcome run(const Invocation& invocation) {
    const auto simulated = readSimulation(invocation);
    if (!simulated) return tl::unexpected(simulated.error());
    const auto path = readPtyPath(invocation);
    if (!path) return tl::unexpected(path.error());
    return servePtysUntilTold(invocation, QStringLiteral("?protocol=smartdevice"), [&](Scheduler& scheduler) {
        auto simulation = std::make_unique<BoardSimulation>(scheduler, *simulated);
        std::vector<ServedLine> lines;
        // Several boards have several ports: PATH, PATH1, PATH2, …
        for (int i = 0; i < simulation->count(); ++i)
            lines.push_back({&simulation->device(i), i == 0 ? *path : *path + std::to_string(i)});
        return PtySimulation{std::move(simulation), std::move(lines)};
    });
}

constexpr std::array kOptions{
    OptionSpec{"--pty", "PATH",
               QT_TRANSLATE_NOOP("kickstand_sim",
                                 "where the serial port is to be; of several boards PATH, PATH1, PATH2, …")},
    OptionSpec{"--type", "LIST",
               QT_TRANSLATE_NOOP("kickstand_sim",
                                 "the boards, as in PolarBear,Encoder.hibike; one PolarBear without it")},
    OptionSpec{"--boot", "MS",
               QT_TRANSLATE_NOOP("kickstand_sim", "from the opening of the port to the first answer")},
    OptionSpec{"--data", "BYTES",
               QT_TRANSLATE_NOOP("kickstand_sim",
                                 "values of more bytes than this come in several messages; 40 without it")},
    kSeedOption,
    kControlOption,
    kJsonOption,
};

}  // namespace

CommandSpec smartDeviceCommand() {
    return {"smartdevice",
            "",
            0,
            QT_TRANSLATE_NOOP("kickstand_sim", "Serves simulated smart devices on pseudo-terminals."),
            kServingDetails,
            kOptions,
            "smartdevice --type PolarBear --pty /tmp/polarbear",
            run};
}

}  // namespace kickstand::sim
