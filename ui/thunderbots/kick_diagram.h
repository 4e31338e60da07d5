#pragma once

#include <array>

#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::ui {

// The pulse diagram without its widget: where edges are, and what pulling one does. Pure.

/// An edge of a pulse that a person can take hold of.
enum class PulseEdge { Start1, End1, Start2, End2 };
inline constexpr std::array kPulseEdges{PulseEdge::Start1, PulseEdge::End1, PulseEdge::Start2,
                                        PulseEdge::End2};

/// 1 or 2.
int solenoidOf(PulseEdge edge);
bool isStart(PulseEdge edge);

/// Pixels and microseconds along one line.
struct PulseAxis {
    double left_px = 0;  ///< Where the kick is: 0 µs.
    double right_px = 1;
    int span_us = thunderbots::wire::kKickMax_us;  ///< At `right_px`.

    double pixelOf(double time_us) const;
    /// The nearest time on the wire's grid that exists: 0-4064 µs, in steps of 32.
    int timeOf(double pixel) const;
};

/// The nearest multiple of 32 µs, half-way values towards zero, as the encoder has it.
int onGrid(int value_us);
/// Brings a time onto the grid and into 0-4064 µs.
int snappedTime(int time_us);
/// When a solenoid is switched on, whether its pulse has a width or not: with the kick, but for the later one
/// of two pulses.
int startOf(const thunderbots::wire::KickPulses& pulses, int solenoid);
/// When an edge is, after the moment of the kick. Past 4064 µs for a pulse that does not fit.
int timeOf(const thunderbots::wire::KickPulses& pulses, PulseEdge edge);
/// Whether an edge can be pulled: a solenoid without a pulse has only its falling edge, and of the two
/// leading edges the earlier one is the kick itself and stays where it is.
bool canPull(const thunderbots::wire::KickPulses& pulses, PulseEdge edge);
/// The pulses once an edge has been pulled to a time. It alone moves, never past the other edge of its pulse,
/// nor off the grid; only where a pulse goes, the other one begins with the kick. Unchanged where it cannot
/// be pulled.
thunderbots::wire::KickPulses pulled(const thunderbots::wire::KickPulses& pulses, PulseEdge edge,
                                     int time_us);

}  // namespace kickstand::ui
