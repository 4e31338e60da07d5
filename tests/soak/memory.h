#pragma once

#include <optional>

#include "core/engine/messages.h"

namespace kickstand::soak {

/// Memory in use, in MB; 0 where the system does not say.
double resident_MB();
/// Memory that the program has asked for and not given back, in MB, whether it was ever touched or not: rings
/// that are reserved once and fill for hours do not grow it, a leak does. Empty where nobody counts, as under
/// a sanitizer's own allocator.
std::optional<double> allocated_MB();
/// What the telemetry's rings of a snapshot have taken so far, which they do once and as they fill.
double rings_MB(const EngineSnapshot& snapshot);

}  // namespace kickstand::soak
