#pragma once

#include <functional>
#include <memory>

#include "app/kickstandctl/command.h"
#include "core/engine/engine.h"

namespace kickstand::ctl {

/// A coach command's hold on the engine: connects, asks, waits, and keeps the heartbeat going while it waits,
/// so that a boat is stopped as soon as this program stops responding. Every wait ends early on a signal, on
/// a STOP that something else caused, and when the link is lost. Main thread.
class CoachRunner {
  public:
    explicit CoachRunner(const Context& context);
    /// As finish().
    ~CoachRunner();
    CoachRunner(const CoachRunner&) = delete;
    CoachRunner& operator=(const CoachRunner&) = delete;

    /// Opens the link that was named and waits until its radio module answers; with `anyModule` also until
    /// none did.
    Outcome connect(bool anyModule = false);
    /// Hands in a command and waits for its answer.
    Outcome perform(const coach::Command& command, Duration limit = std::chrono::seconds(5));
    /// Hands in a command without waiting: its answer is dropped.
    void give(const coach::Command& command) {
        static_cast<void>(engine_.submit(session_, SystemCommand(command)));
    }
    /// True when `met` came true, false when the time was over first.
    Expected<bool> waitUntil(const std::function<bool()>& met, Duration limit);
    /// Plays the COACH that the module is set up for, and pairs it with a boat: its own team's where `boat`
    /// is negative.
    Outcome pairWith(int boat, coach::wire::TeamColor color);

    /// What the link showed last. Only after connect().
    const coach::Snapshot& state() const;
    Engine& engine() { return engine_; }
    const LinkUri& uri() const { return uri_; }
    /// Called for every event from now on, while something waits.
    void setObserver(std::function<void(const EngineEvent&)> observer) { observer_ = std::move(observer); }

    /// STOP, waits until zero velocity has been sent, and closes. True when a boat that was paired was told
    /// to stop, or none was paired. Bounded; safe to call twice.
    bool finish();

  private:
    Outcome trouble() const;
    const SessionSnapshot* session() const;
    Outcome pairAfterStartup(coach::wire::Team boat);
    void refresh();

    const Context& context_;
    Engine engine_;
    LinkUri uri_;
    SessionId session_ = 0;
    bool connected_ = false;
    bool finished_ = false;
    bool stopped_ = false;
    std::shared_ptr<const EngineSnapshot> snapshot_;
    std::uint64_t cursor_ = 0;
    std::function<void(const EngineEvent&)> observer_;
};

}  // namespace kickstand::ctl
