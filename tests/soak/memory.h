#pragma once

#include "core/engine/messages.h"

namespace kickstand::soak {

/// Memory in use, in MB; 0 where the system does not say.
double resident_MB();
/// What the telemetry's rings of a snapshot have taken so far, which they do once and as they fill.
double rings_MB(const EngineSnapshot& snapshot);

}  // namespace kickstand::soak
