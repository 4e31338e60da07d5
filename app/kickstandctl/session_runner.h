#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/kickstandctl/command.h"
#include "core/engine/engine.h"

namespace kickstand::ctl {

/// A command's hold on the engine: connects, asks, waits, and keeps the heartbeat going while it waits, so
/// that robots brake as soon as this program stops responding. Every wait ends early on a signal, on a STOP
/// that something else caused, and when a link that ran does not run any more. Main thread.
class SessionRunner {
  public:
    explicit SessionRunner(const Context& context);
    /// As finish().
    ~SessionRunner();

    /// What is plugged in.
    Expected<std::vector<FoundDevice>> discover();
    /// The link that was asked for, or the only hardware there is.
    Expected<LinkUri> chooseLink();
    /// What a command needs of its link.
    enum class Need {
        Running,  ///< It runs, all robots braked.
        Open,     ///< It is open, though what it leads to may have to be set up first.
    };
    /// Opens the link and waits until it is as it has to be.
    Outcome connect(const LinkUri& uri, Need need = Need::Running);
    /// chooseLink() and connect().
    Outcome connect();
    /// Waits until these robots are heard.
    Outcome awaitRobots(thunderbots::RobotMask robots);
    /// From now on no STOP ends a wait, nor a link that is lost and looked for: for what only watches.
    void watchOnly() { watchesOnly_ = true; }
    /// Waits until what a robot says of itself is known.
    Outcome awaitReadings(int robot);
    /// Waits until nothing new comes: every robot that is heard has readings, or two seconds have passed.
    Outcome settle();
    /// Hands in a command and waits for its answer.
    Outcome perform(const SystemCommand& command, Duration limit = std::chrono::seconds(5));
    /// True when `met` came true, false when the time was over first.
    Expected<bool> waitUntil(const std::function<bool()>& met, Duration limit);

    /// What the link showed last. Only after connect().
    const thunderbots::Snapshot& state() const { return stateOf<thunderbots::Snapshot>(); }
    /// The same for any system; a default one where the link is of another.
    template <class Snapshot>
    const Snapshot& stateOf() const {
        static const Snapshot kNothing;
        const SessionSnapshot* const current = session();
        const auto* const system = current == nullptr ? nullptr : std::get_if<Snapshot>(&current->system);
        return system == nullptr ? kNothing : *system;
    }
    const thunderbots::RobotState& robot(int number) const {
        return state().robots[static_cast<std::size_t>(number)];
    }
    /// The whole session, whether its link runs or not; null where there is none.
    const SessionSnapshot* session() const;
    const LinkUri& uri() const { return uri_; }
    Engine& engine() { return engine_; }
    /// Called for every event from now on, while something waits.
    void setObserver(std::function<void(const EngineEvent&)> observer) { observer_ = std::move(observer); }

    /// STOP for all robots, waits until the link has taken it, and closes. True when every robot was told to
    /// brake; false when the link could not be asked any more. Bounded; safe to call twice.
    bool finish();
    /// Closes without STOP: for what has moved nothing and is not to stop what others have set going.
    void leave();

  private:
    /// How the link stands, whichever system it is of.
    struct Standing {
        bool running = false;
        bool unready = false;  ///< Open, and nothing at its end that could be used as it is.
        bool searching = false;
        bool failed = false;
        std::optional<Error> error{};
    };
    Standing standing() const;
    /// How long the robots' being told, or their word that they stand, is waited for at the end.
    Duration brakeLimit() const;
    Outcome trouble() const;
    /// Why a command that moves something ends when STOP is latched.
    Failure stopped() const;
    bool atRest(TimePoint since) const;
    void refresh();

    const Context& context_;
    Engine engine_;
    LinkUri uri_;
    SessionId session_ = 0;
    bool running_ = false;  ///< Whether the link has to run from now on.
    bool watchesOnly_ = false;
    bool finished_ = false;
    bool braked_ = false;
    std::shared_ptr<const EngineSnapshot> snapshot_;
    std::uint64_t cursor_ = 0;
    std::function<void(const EngineEvent&)> observer_;
};

}  // namespace kickstand::ctl
