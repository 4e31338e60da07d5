#pragma once

#include <QString>

#include "core/engine/messages.h"

namespace kickstand {

/// What STOP has done to a system and what stays unknown, to stand beside "STOPPED". Any thread once the
/// application object exists.
QString stoppedText(const SystemSnapshot& system, StopReason reason);

}  // namespace kickstand
