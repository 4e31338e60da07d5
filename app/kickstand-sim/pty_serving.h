#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/kickstand-sim/command.h"
#include "app/kickstand-sim/pty_carrier.h"
#include "core/base/scheduler.h"

namespace kickstand::sim {

// What the families have in common that are served on pseudo-terminals.

/// `--pty`, one path or several with commas between them, made absolute. Missing: exit 2.
ctl::Expected<std::vector<std::string>> readPtyPaths(const Invocation& invocation);
/// The same for one path, which may have commas in it.
ctl::Expected<std::string> readPtyPath(const Invocation& invocation);

/// A simulation and the serial lines of its devices.
struct PtySimulation {
    std::unique_ptr<Simulation> simulation;
    std::vector<ServedLine> lines;
};
using MakePtySimulation = std::function<PtySimulation(Scheduler& scheduler)>;

/// Serves what `make` makes until a signal ends it. `link` is what follows a path in a link URI.
ctl::Outcome servePtysUntilTold(const Invocation& invocation, const QString& link,
                                const MakePtySimulation& make);

}  // namespace kickstand::sim
