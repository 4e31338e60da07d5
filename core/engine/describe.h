#pragma once

#include <QString>

#include "core/engine/messages.h"

namespace kickstand {

// The edge where facts become sentences: what the window and the command line show. Translatable. Any thread
// once the application object exists.

/// What went wrong, and what to do about it.
struct Description {
    QString what;
    QString remedy;         ///< Empty where there is nothing to be done.
    QString remedyCommand;  ///< A shell command that does it, where one does.
    /// "What. Remedy." in one line.
    QString line() const;
};
/// The sentence for an error, and its remedy where there is one.
Description describe(const Error& error);

/// How much an event matters to somebody who reads a list of them.
enum class Severity { Information, Warning, Danger };

/// One event in plain words, without its time and robot.
struct EventText {
    QString text;
    Severity severity = Severity::Information;
};
/// The words for an event, and how much it matters.
EventText describe(const EngineEvent& event);
/// The robot an event concerns, or -1; of smart devices the board's number.
int robotOf(const EngineEvent& event);
/// "robot 3", "PolarBear 0": whom an event concerns; empty where nobody in particular.
QString aboutOf(const EngineEvent& event);
/// When it happened, on the engine's clock.
TimePoint timeOf(const EngineEvent& event);

/// Why STOP is latched, to follow "Stopped: ".
QString describe(StopReason reason);
/// A state in a word or two, as labels show it.
QString describe(thunderbots::LinkState state);
/// As the dongle reports its emergency stop (protocol 3.8).
QString describe(thunderbots::wire::EStop state);
/// As the dongle reports its radios (protocol 3.8).
QString describe(thunderbots::wire::RadioState state);

}  // namespace kickstand
