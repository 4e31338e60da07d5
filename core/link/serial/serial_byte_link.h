#pragma once

#include <memory>
#include <string>

#include "core/base/scheduler.h"
#include "core/link/byte_link.h"

namespace kickstand {

/// A link to a serial port of this machine, by its name ("/dev/ttyACM0", a symbolic link to one, a
/// pseudo-terminal, "COM3"). What may block happens on a thread that the link has of its own; destroying it
/// waits for the end of an opening that is under way. The program has a QCoreApplication. `scheduler` must
/// outlive it. Scheduler's thread.
std::unique_ptr<ByteLink> makeSerialByteLink(Scheduler& scheduler, std::string port, Baud baud);

}  // namespace kickstand
