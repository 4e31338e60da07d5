#pragma once

#include <variant>

#include "core/coach/commands.h"
#include "core/coach/events.h"
#include "core/coach/snapshot.h"
#include "core/motionplan/commands.h"
#include "core/motionplan/events.h"
#include "core/motionplan/snapshot.h"
#include "core/smartdevice/commands.h"
#include "core/smartdevice/events.h"
#include "core/smartdevice/snapshot.h"
#include "core/thunderbots/commands.h"
#include "core/thunderbots/events.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand {

// The systems that the engine knows. A new one adds an alternative to each line here, and a line to
// core/engine/session_registry.cpp.
using SystemCommand =
    std::variant<thunderbots::Command, motionplan::Command, coach::Command, smartdevice::Command>;
using SystemEvent = std::variant<thunderbots::Event, motionplan::Event, coach::Event, smartdevice::Event>;
using SystemSnapshot =
    std::variant<thunderbots::Snapshot, motionplan::Snapshot, coach::Snapshot, smartdevice::Snapshot>;

/// Whether a command may set something in motion, charge it or arm it. Each may that does not say
/// `kMovesNothing` of itself. Any thread.
inline bool mayMove(const SystemCommand& command) {
    const auto ofOne = []<class One>(const One&) {
        if constexpr (requires { One::kMovesNothing; }) return !One::kMovesNothing;
        return true;
    };
    return std::visit([&](const auto& system) { return std::visit(ofOne, system); }, command);
}

}  // namespace kickstand
