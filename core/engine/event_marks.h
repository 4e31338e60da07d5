#pragma once

#include <optional>

#include "core/engine/systems.h"
#include "core/telemetry/marks.h"

namespace kickstand {

/// What a plot marks on its time axis of an event; nothing of most. Any thread.
std::optional<Mark> markOf(const SystemEvent& event);

}  // namespace kickstand
