#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "core/engine/engine.h"
#include "core/engine/flow/bounded_queue.h"
#include "core/engine/flow/event_ring.h"
#include "core/engine/flow/heartbeat.h"
#include "core/engine/flow/snapshot_cell.h"
#include "core/engine/session_slot.h"

namespace kickstand {

/// The four flows between the engine's thread and everybody else, and the two things that anybody may set at
/// any time. Each is bounded.
struct EngineFlows {
    static constexpr std::size_t kCommands = 1024;
    static constexpr std::size_t kAnswers = 4096;
    static constexpr std::size_t kEvents = 8192;

    BoundedQueue<Command> commands{kCommands};
    BoundedQueue<Answer> answers{kAnswers};
    EventRing<EngineEvent> events{kEvents};
    SnapshotCell<EngineSnapshot> snapshots;
    StopLatch stop;
    Heartbeat heartbeat;
};

/// What the engine's thread does, without the thread: runs on whatever scheduler it is given, so that a fake
/// one can run it through a day. Everything but the flows is used on the scheduler's thread.
class EngineCore {
  public:
    /// Scheduler and links must outlive it. Nothing happens before start().
    EngineCore(Scheduler& scheduler, LinkProvider& links, const EngineOptions& options);
    ~EngineCore();

    EngineFlows& flows() { return flows_; }

    /// Begins the safety step.
    void start();
    /// A command waits, or the latch has changed: asks the scheduler to look, once for however much comes
    /// before it does. Any thread.
    void wake();
    /// Takes commands from the queue; where there are many, some now and the rest in turns of their own, so
    /// that a flood of them holds up nothing else.
    void takeCommands();
    /// Brakes and closes every session; `done` comes once, within the options' limit. Commands are refused
    /// from here on. Once.
    void shutdown(std::function<void()> done);
    /// Destroys every session, without ceremony.
    void endSessions();

  private:
    /// A session that is being disconnected.
    struct Closing {
        std::unique_ptr<SessionSlot> slot;
        CommandId command = 0;
        TimerId deadline = 0;
    };

    void step();
    /// Sees whether this thread or the whole machine stood still for longer than a dead-man may: then nobody
    /// watched.
    void noticePause();
    /// Acts on the latch where it has been set or taken back.
    void latchChanged();
    void execute(Command& command);
    Result<void> connect(SessionId id, const LinkUri& uri);
    void disconnect(CommandId id, std::size_t at);
    void closed(const SessionSlot* slot);
    void oneShutDown();
    void tellLatch(EngineNote::Kind kind, StopReason reason);
    void discover(CommandId id);
    void answer(Answer answer);
    void note(EngineNote note, SessionId session = 0);
    void publishIfChanged();
    std::uint64_t versions() const;
    std::size_t find(SessionId id) const;

    Scheduler& scheduler_;
    LinkProvider& links_;
    EngineOptions options_;
    EngineFlows flows_;
    std::vector<std::unique_ptr<SessionSlot>> sessions_;
    std::vector<Closing> closing_;
    std::vector<FoundDevice> found_;
    std::vector<BytePort> ports_;
    bool discovered_ = false;
    std::uint64_t stopsSeen_ = 0;  ///< Of the latch's count: how many have been acted on.
    std::uint64_t pressesSeen_ = 0;
    bool stopTold_ = false;
    bool ending_ = false;  ///< shutdown() has been called: commands are refused.
    bool heartbeatFresh_ = false;
    TimePoint lookedAt_{};
    Duration asleep_{};
    std::uint64_t answersLost_ = 0;
    std::uint64_t ownVersion_ = 1;
    std::uint64_t publishedVersion_ = 0;
    TimerId stepTimer_ = 0;
    std::function<void()> shutDown_;  ///< To be called when the last session has closed.
    std::size_t toShutDown_ = 0;
    TimerId shutdownDeadline_ = 0;
    std::atomic<bool> woken_{false};
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace kickstand
