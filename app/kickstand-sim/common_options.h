#pragma once

#include <QtGlobal>

#include "app/kickstand-sim/command.h"

namespace kickstand::sim {

// Options that every family takes.

inline constexpr OptionSpec kSeedOption{
    "--seed", "N",
    QT_TRANSLATE_NOOP("kickstand_sim", "of all that happens by chance: the same seed, the same chances")};
inline constexpr OptionSpec kControlOption{
    "--control", "PATH",
    QT_TRANSLATE_NOOP("kickstand_sim", "the control socket; $XDG_RUNTIME_DIR/kickstand-sim.sock without it")};
inline constexpr OptionSpec kJsonOption{
    "--json", "", QT_TRANSLATE_NOOP("kickstand_sim", "what is said as JSON, a value a line")};

/// "It says how to reach it, …": what the help of each says besides.
inline constexpr const char* kServingDetails = QT_TRANSLATE_NOOP(
    "kickstand_sim", "It says how to reach it, and goes on until Ctrl+C, SIGTERM or SIGHUP.");

}  // namespace kickstand::sim
