#pragma once

#include <memory>

#include "core/engine/link_provider.h"

namespace kickstand {

/// The links that the programs are built with: `usb:` and `usb-cable:`, each with `?port=1-2.3` where several
/// are plugged in, `usbip:HOST:PORT/BUSID`, `serial:PATH?protocol=NAME&baud=N`, and `sim:thunderbots` and its
/// like with the simulators' options.
std::unique_ptr<LinkProvider> makeLinkProvider();

/// Whether such a link exists, without making it. Errors: BadUri for a scheme, target or option that is not
/// taken, Unsupported for a system that is not simulated here, both with what is taken in `detail`; those of
/// the simulator's options. Any thread.
Result<void> checkLink(const LinkUri& uri);

}  // namespace kickstand
