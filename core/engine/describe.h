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
Description describe(const Error& error);

/// How much an event matters to somebody who reads a list of them.
enum class Severity { Information, Warning, Danger };

/// One event in plain words, without its time and robot.
struct EventText {
    QString text;
    Severity severity = Severity::Information;
};
EventText describe(const EngineEvent& event);
/// The robot an event concerns, or -1.
int robotOf(const EngineEvent& event);
/// When it happened, on the engine's clock.
TimePoint timeOf(const EngineEvent& event);

QString describe(StopReason reason);
QString describe(thunderbots::LinkState state);
QString describe(thunderbots::wire::EStop state);
QString describe(thunderbots::wire::RadioState state);

}  // namespace kickstand
