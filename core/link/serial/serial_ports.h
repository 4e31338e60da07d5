#pragma once

#include <memory>
#include <string>

#include "core/base/scheduler.h"
#include "core/link/byte_ports.h"

namespace kickstand {

/// The serial ports of this machine that are on USB; or, where a name is given, that port alone, whatever it
/// is, as long as it is there. They are looked for twice a second on a thread of its own, which begins with
/// watch(). `scheduler` must outlive it. Scheduler's thread.
std::unique_ptr<BytePorts> makeSerialPorts(Scheduler& scheduler, std::string only = {});

}  // namespace kickstand
