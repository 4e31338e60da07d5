#include "app/composition/simulated_lines.h"

#include <string_view>

#include "core/coach/sim/coach_sim.h"
#include "core/link/paced/paced_byte_link.h"
#include "core/motionplan/sim/nxt_sim.h"

namespace kickstand {
namespace {

/// About what a Bluetooth serial port carries.
constexpr Baud kBluetoothBaud = 115200;

struct SimulatedSystem {
    std::string_view name;
    Result<void> (*check)(const LinkUri& uri);
    Result<SimulatedLine> (*make)(const LinkUri& uri, Scheduler& scheduler);
};

Result<void> checkMotionplan(const LinkUri& uri) {
    const auto options = motionplan::sim::parseNxtOptions(uri.options);
    if (!options) return fail(options.error());
    return {};
}

Result<SimulatedLine> makeMotionplan(const LinkUri& uri, Scheduler& scheduler) {
    const auto options = motionplan::sim::parseNxtOptions(uri.options);
    if (!options) return fail(options.error());
    const auto sim = std::make_shared<motionplan::sim::NxtSim>(scheduler, *options);
    return SimulatedLine{sim, sim.get(), &sim->control(), kBluetoothBaud, "simulated NXT"};
}

Result<void> checkCoach(const LinkUri& uri) {
    const auto options = coach::sim::parseSimOptions(uri);
    return options ? Result<void>() : fail(options.error());
}

Result<SimulatedLine> makeCoach(const LinkUri& uri, Scheduler& scheduler) {
    const auto options = coach::sim::parseSimOptions(uri);
    if (!options) return fail(options.error());
    const auto sim = std::make_shared<coach::sim::CoachSim>(scheduler, *options);
    return SimulatedLine{sim, &sim->module(0), sim.get(), 9600, "XBee adapter"};
}

/// One line a system.
constexpr SimulatedSystem kSystems[] = {
    {"motionplan", checkMotionplan, makeMotionplan},
    {"coach", checkCoach, makeCoach},
};

const SimulatedSystem* systemOf(const LinkUri& uri) {
    if (!uri.isSimulated()) return nullptr;
    for (const SimulatedSystem& system : kSystems) {
        if (uri.target == system.name) return &system;
    }
    return nullptr;
}

}  // namespace

bool isSimulatedLine(const LinkUri& uri) {
    return systemOf(uri) != nullptr;
}

std::string simulatedLineNames() {
    std::string names;
    for (const SimulatedSystem& system : kSystems)
        names += (names.empty() ? "sim:" : ", sim:") + std::string(system.name);
    return names;
}

Result<void> checkSimulatedLine(const LinkUri& uri) {
    return systemOf(uri)->check(uri);
}

Result<ProvidedByteLink> makeSimulatedLine(const LinkUri& uri, Scheduler& scheduler) {
    auto line = systemOf(uri)->make(uri, scheduler);
    if (!line) return fail(std::move(line.error()));
    ProvidedByteLink provided;
    PacedLineOptions options;
    options.port = uri.target;
    options.description = line->description;
    options.baud = line->baud;
    provided.link = std::make_unique<PacedByteLink>(scheduler, *line->device, std::move(options));
    provided.sim = line->control;
    provided.keepAlive = std::move(line->keepAlive);
    return provided;
}

}  // namespace kickstand
