#pragma once

#include <string>

#include "core/engine/link_provider.h"

namespace kickstand {

/// Whether this is a serial port of this machine (`serial:PATH?protocol=coach&baud=9600`).
bool isSerial(const LinkUri& uri);

/// Errors: BadUri for another protocol or option, a speed that is none, or no port where one is needed. The
/// protocol may be left out for smart devices, which also may leave out the port: all on USB are meant then.
Result<void> checkSerialLink(const LinkUri& uri);

/// A link to that port. Errors as checkSerialLink(); BadUri without a port.
Result<ProvidedByteLink> makeSerialLink(const LinkUri& uri, Scheduler& scheduler);

/// The ports to look for smart devices at. Errors as checkSerialLink().
Result<ProvidedBytePorts> makeSerialPortList(const LinkUri& uri, Scheduler& scheduler);

}  // namespace kickstand
