#pragma once

#include <variant>

#include "core/thunderbots/commands.h"
#include "core/thunderbots/events.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand {

// The systems that the engine knows. A new one adds an alternative to each line here, and a line to
// core/engine/session_registry.cpp.
using SystemCommand = std::variant<thunderbots::Command>;
using SystemEvent = std::variant<thunderbots::Event>;
using SystemSnapshot = std::variant<thunderbots::Snapshot>;

}  // namespace kickstand
