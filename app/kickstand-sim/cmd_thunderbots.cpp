#include <algorithm>
#include <array>

#include "app/kickstand-sim/common_options.h"
#include "app/kickstand-sim/families.h"
#include "app/kickstand-sim/serving.h"
#include "app/kickstand-sim/thunderbots_simulation.h"
#include "app/kickstand-sim/usbip_carrier.h"
#include "app/kickstand-sim/words.h"
#include "app/kickstandctl/values.h"
#include "core/link/link_uri.h"

namespace kickstand::sim {
namespace {

using thunderbots::sim::ThunderbotsSimOptions;

/// Options of the simulator itself, and what they are called in a link: both mean the same, and are judged in
/// one place.
struct SimOption {
    const char* option;
    const char* name;
    const char* accepted;
};
constexpr std::array<SimOption, 5> kSimOptions{
    {{"--robots", "robots", QT_TRANSLATE_NOOP("kickstand-sim", "Numbers from 0 to 15, as in 0,3,5-7.")},
     {"--radio", "radio", QT_TRANSLATE_NOOP("kickstand-sim", "One of: true, ideal.")},
     {"--loss", "loss", QT_TRANSLATE_NOOP("kickstand-sim", "A share from 0 to 1, as in 0.05.")},
     {"--seed", "seed", QT_TRANSLATE_NOOP("kickstand-sim", "A whole number from 0 on.")},
     {"--cable", "cable", QT_TRANSLATE_NOOP("kickstand-sim", "The robot's number, 0 to 15.")}}};

/// What was wrong with an option of the simulation, under the name by which it was given.
ctl::Failure explain(Error error, const Invocation& given) {
    const auto* const found =
        std::find_if(kSimOptions.begin(), kSimOptions.end(),
                     [&error](const SimOption& known) { return error.subject == known.name; });
    if (found != kSimOptions.end()) error.subject = found->option;
    ctl::Failure failure = ctl::refusedInput(error).value();
    // What cannot go together is told by the error itself.
    const bool unreadable = found != kSimOptions.end() && error.detail == given.text(found->option);
    if (unreadable) failure.text.remedy = Words::tr(found->accepted);
    return failure;
}

ctl::Expected<ThunderbotsSimOptions> readSimulation(const Invocation& invocation) {
    LinkUri uri{.scheme = "sim", .target = "thunderbots", .options = {}};
    for (const auto& [option, name, accepted] : kSimOptions) {
        if (invocation.has(option)) uri.options[name] = invocation.text(option);
    }
    auto options = thunderbots::sim::parseSimOptions(uri);
    if (!options) return tl::unexpected(explain(options.error(), invocation));
    return *options;
}

ctl::Expected<UsbipServerOptions> readServer(const Invocation& invocation) {
    UsbipServerOptions options;
    if (!invocation.has("--usbip"))
        return ctl::badUsage(Words::tr("Nothing says how the device is to be served."),
                             Words::tr("Add --usbip: over USB/IP."));
    if (invocation.has("--port")) {
        const auto port = ctl::parseWhole(invocation.text("--port"), "--port", 0, UINT16_MAX);
        if (!port) return tl::unexpected(port.error());
        options.port = static_cast<std::uint16_t>(*port);
    }
    if (invocation.has("--address")) options.address = invocation.text("--address");
    options.anyAddress = invocation.has("--any-address");
    return options;
}

ctl::Outcome run(const Invocation& invocation) {
    const auto simulated = readSimulation(invocation);
    if (!simulated) return tl::unexpected(simulated.error());
    const auto server = readServer(invocation);
    if (!server) return tl::unexpected(server.error());
    return serveUntilTold(invocation, [&](Scheduler& scheduler, Log& log) -> ctl::Expected<Served> {
        auto simulation = std::make_unique<ThunderbotsSimulation>(scheduler, *simulated);
        auto carrier = UsbipCarrier::serve(scheduler, simulation->device(), *server,
                                           [&log](const std::string& line) { log.event(line); });
        if (!carrier) return tl::unexpected(carrier.error());
        return Served{std::move(simulation), std::move(*carrier)};
    });
}

constexpr std::array kOptions{
    OptionSpec{"--usbip", "",
               QT_TRANSLATE_NOOP("kickstand_sim", "serve it over USB/IP, under the bus id 1-1")},
    OptionSpec{"--port", "N",
               QT_TRANSLATE_NOOP("kickstand_sim", "TCP port; 3240 without it, 0 for any that is free")},
    OptionSpec{"--address", "A", QT_TRANSLATE_NOOP("kickstand_sim", "where to listen; 127.0.0.1 without it")},
    OptionSpec{"--any-address", "",
               QT_TRANSLATE_NOOP(
                   "kickstand_sim",
                   "let --address be one that other machines reach: whoever reaches it can use the device")},
    OptionSpec{
        "--robots", "LIST",
        QT_TRANSLATE_NOOP("kickstand_sim", "which robots there are, as in 0,3,5-7; all sixteen without it")},
    OptionSpec{"--radio", "true|ideal",
               QT_TRANSLATE_NOOP("kickstand_sim", "the pace of the real radio, or none; true without it")},
    OptionSpec{"--loss", "P",
               QT_TRANSLATE_NOOP("kickstand_sim", "which part of the radio packets is lost, 0 to 1")},
    kSeedOption,
    OptionSpec{"--cable", "N", QT_TRANSLATE_NOOP("kickstand_sim", "no dongle, but this robot on its cable")},
    kControlOption,
    kJsonOption,
};

}  // namespace

CommandSpec thunderbotsCommand() {
    return {"thunderbots",
            "",
            0,
            QT_TRANSLATE_NOOP("kickstand_sim",
                              "Serves the simulated Thunderbots dongle, or one robot on a cable."),
            kServingDetails,
            kOptions,
            "thunderbots --usbip --robots 0,3,5 --loss 0.02",
            run};
}

}  // namespace kickstand::sim
