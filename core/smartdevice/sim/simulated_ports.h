#pragma once

#include <memory>

#include "core/link/byte_ports.h"
#include "core/link/paced/byte_faults.h"
#include "core/smartdevice/sim/smartdevice_sim.h"

namespace kickstand::smartdevice::sim {

/// The ports that the boards of a simulator are at, in this process and at the pace of their lines. Both must
/// outlive it; it is the simulator's plug listener. The scheduler's thread.
std::unique_ptr<BytePorts> makeSimulatedPorts(Scheduler& scheduler, SmartDeviceSim& sim,
                                              const ByteFaultOptions& faults = {});

}  // namespace kickstand::smartdevice::sim
