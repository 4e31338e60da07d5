#pragma once

#include <functional>
#include <memory>

#include "app/kickstand-sim/command.h"
#include "app/kickstand-sim/log.h"
#include "app/kickstand-sim/simulation.h"
#include "core/base/scheduler.h"

namespace kickstand::sim {

/// Simulated units and what carries them; the carrier goes first.
struct Served {
    std::unique_ptr<Simulation> simulation;
    std::unique_ptr<Carrier> carrier;
};
using Make = std::function<ctl::Expected<Served>(Scheduler& scheduler, Log& log)>;

/// Serves what `make` makes, with its control socket, until a signal ends it: what every family's command
/// does once its options are understood. `make` is called on the simulator's thread. Options: `--control`,
/// `--json`. Main thread, before any other is made.
ctl::Outcome serveUntilTold(const Invocation& invocation, const Make& make);

}  // namespace kickstand::sim
