#pragma once

#include <QJsonObject>

#include "app/kickstandctl/coach_link.h"

namespace kickstand::ctl {

/// A coach command that plays a side: a stream of events, and an end that says whether the boat was told to
/// stop.
class CoachPlay {
  public:
    explicit CoachPlay(const Context& context) : context_(context), runner_(context) {}

    SessionRunner& runner() { return runner_; }
    /// Connects; from then on every event is told.
    Outcome connect();
    /// connect(), and pairs with `--boat` in `--color`.
    Outcome pair();
    /// Says something: a line for a person, a value of this "type" for a script.
    void tell(const QString& type, QJsonObject facts, const QString& text);
    /// Lets that much time pass while both stay paired.
    Outcome keepFor(Duration span);
    /// Waits until so many packets of that kind have been sent and what became of the last is known.
    Outcome awaitSent(coach::wire::Opcode opcode);
    /// Stops and says how it ended; gives back `outcome`, or that stopping failed.
    Outcome end(Outcome outcome);

  private:
    const Context& context_;
    SessionRunner runner_;
};

/// "red" or "blue"; red where nothing was given.
Expected<coach::wire::TeamColor> readColor(const Invocation& invocation);

}  // namespace kickstand::ctl
