#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/sleep_clock.h"
#include "core/engine/flow/event_ring.h"
#include "core/engine/messages.h"

namespace kickstand {

/// What can be set of an engine before it starts.
struct EngineOptions {
    /// A heartbeat older than this brakes everything (design: dead-man; the bound to the wheels is 0.6 s).
    Duration heartbeatLimit = std::chrono::milliseconds(400);
    /// How long the machine has slept so far; a jump of it stops what moves.
    std::function<Duration()> timeAsleep = kickstand::timeAsleep;
    /// How long shutdown() waits at most for the last braked blocks.
    Duration shutdownLimit = std::chrono::milliseconds(500);
};

/// The engine: one thread that runs every session, seen from outside. Commands go in, snapshots, events and
/// telemetry come out; each of the four is bounded. Every method may be called from any thread and none waits
/// for the engine thread, except shutdown() and the destructor.
class Engine {
  public:
    explicit Engine(std::unique_ptr<LinkProvider> links, const EngineOptions& options = {});
    /// As shutdown().
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Opens a session; its id is in the snapshot once the engine has begun it. Errors: QueueFull.
    Result<SessionId> connect(const LinkUri& uri);
    /// Hands in a command for a session (0 for Discover). Errors: QueueFull.
    Result<CommandId> submit(SessionId session, CommandBody body);
    /// Takes the answers that have come since the last call. One caller.
    std::vector<Answer> takeAnswers();

    /// STOP: latched before this returns, and braked blocks follow at once. Never fails, never waits.
    void stop(StopReason reason = StopReason::Person);
    /// Re-arms after a STOP: a separate act of a person.
    void rearm();
    bool isStopped() const;
    /// "The person's side is alive": to be called at least every 100 ms by whoever drives. Without it nothing
    /// moves.
    void heartbeat();

    /// The latest state; never null.
    std::shared_ptr<const EngineSnapshot> snapshot() const;
    /// Rises with every new snapshot: a cheap way to see that nothing changed.
    std::uint64_t snapshotVersion() const;
    /// The events after the cursor, which is moved on.
    EventRing<EngineEvent>::Read readEvents(std::uint64_t& cursor) const;

    /// The engine's clock, and what the clock on the wall showed then.
    TimePoint now() const;
    std::chrono::system_clock::time_point wallTime(TimePoint time) const;

    /// Brakes everything, waits (bounded) until the link has taken it, and closes. Safe to call twice.
    void shutdown();

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace kickstand
