#pragma once

#include <QJsonObject>
#include <functional>

#include "app/kickstandctl/command.h"
#include "core/base/time.h"
#include "core/engine/messages.h"
#include "core/thunderbots/types.h"

namespace kickstand::ctl {

class SessionRunner;

/// What the commands that move, charge or kick have in common: a beginning, with the robots heard, and an
/// end, with all of them braked and that said.
class Motion {
  public:
    /// Whether --json prints a value a line as things happen, or one value at the end.
    enum class Style { Stream, OneValue };

    Motion(const Context& context, SessionRunner& runner, Style style);

    /// Connects and waits until the robots are heard. From then on a stream tells every event.
    Outcome begin(thunderbots::RobotMask robots);
    /// Called for the link's events, after they were told.
    void setHook(std::function<void(const thunderbots::Event&)> hook) { hook_ = std::move(hook); }
    /// Called for every event first, the engine's own among them. Before begin().
    void setListener(std::function<void(const EngineEvent&)> listener) { listener_ = std::move(listener); }
    /// Keeps things going for so long.
    Outcome keepFor(Duration span);
    /// Says something: the text in its own line; the facts as a value of this "type" in a stream, and
    /// otherwise as members of the one value.
    void tell(const QString& type, QJsonObject facts, const QString& text);
    /// Brakes everything and says how it ended; gives back `outcome`, or that braking failed.
    Outcome end(Outcome outcome);

  private:
    void told(const EngineEvent& event);

    const Context& context_;
    SessionRunner& runner_;
    const Style style_;
    thunderbots::RobotMask robots_ = 0;
    QJsonObject facts_;
    std::function<void(const EngineEvent&)> listener_;
    std::function<void(const thunderbots::Event&)> hook_;
};

}  // namespace kickstand::ctl
