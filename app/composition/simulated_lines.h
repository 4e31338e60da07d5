#pragma once

#include <string>

#include "core/engine/link_provider.h"
#include "core/link/byte_device_model.h"

namespace kickstand {

/// A simulated device on a serial line.
struct SimulatedLine {
    std::shared_ptr<void> keepAlive;  ///< The simulator that the rest belongs to.
    ByteDeviceModel* device = nullptr;
    SimControl* control = nullptr;  ///< May be null.
    Baud baud = 115200;             ///< What the device speaks.
    std::string description;        ///< What it says it is.
};

/// Whether a system with one simulated device on a serial line has this name (`sim:coach`).
bool isSimulatedLine(const LinkUri& uri);
/// Those names, as a list for people: "sim:coach, sim:motionplan".
std::string simulatedLineNames();
/// Errors: those of the simulator's options.
Result<void> checkSimulatedLine(const LinkUri& uri);
/// The line in this process, at its own pace. Errors as checkSimulatedLine().
Result<ProvidedByteLink> makeSimulatedLine(const LinkUri& uri, Scheduler& scheduler);

}  // namespace kickstand
