#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/byte_ports.h"

namespace kickstand {

/// Every serial port of this machine that the system lists, those on USB first, else by their names; neither
/// pseudo-terminals nor symbolic links are among them. Any thread; may block.
std::vector<BytePort> listSerialPorts();

/// The serial ports of this machine that are on USB; or, where a name is given, that port alone, whatever it
/// is, as long as it is there. They are looked for twice a second on a thread of its own, which begins with
/// watch(). `scheduler` must outlive it. Scheduler's thread.
std::unique_ptr<BytePorts> makeSerialPorts(Scheduler& scheduler, std::string only = {});

}  // namespace kickstand
