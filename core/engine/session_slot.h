#pragma once

#include <functional>
#include <memory>

#include "core/engine/messages.h"
#include "core/engine/session_registry.h"
#include "core/telemetry/store.h"

namespace kickstand {

/// One open session with what belongs to it: its telemetry, its simulator, its place in snapshots. Engine
/// thread.
class SessionSlot final : public SampleSink {
  public:
    /// `event` and `answer` receive what the session says, with its id.
    SessionSlot(SessionId id, LinkUri uri, std::function<void(EngineEvent)> event,
                std::function<void(Answer)> answer);

    /// Makes the session and starts it. Errors: makeSession()'s.
    Result<void> open(LinkProvider& links, Scheduler& scheduler, StopLatch& stop);

    SessionId id() const { return id_; }
    SystemSession& session() { return *made_.session; }
    /// Errors: Unsupported where the link is not simulated; SimControl's.
    Result<void> performSim(const SimPerform& command);
    /// Reads what the simulator's quantities are now, if it is time to. Whether any has changed.
    bool readSim(TimePoint now);
    /// Marks a moment of the engine's own on the session's time axis.
    void mark(MarkKind kind, TimePoint time, float value = 0);
    SessionSnapshot snapshot() const;

    void sample(SignalId signal, TimePoint time, float value) override;
    void gap(SignalId signal, TimePoint time) override;

  private:
    void markEvent(const SystemEvent& event);

    SessionId id_;
    LinkUri uri_;
    std::function<void(EngineEvent)> event_;
    std::function<void(Answer)> answer_;
    std::shared_ptr<TelemetryStore> telemetry_;
    MadeSession made_;
    std::vector<SimReading> simReadings_;
    TimePoint simReadAt_{};
};

}  // namespace kickstand
