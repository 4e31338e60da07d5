#include "core/engine/engine_core.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

/// The two clocks that tell of sleep are read one after the other: a jump smaller than this is none.
constexpr Duration kShortestSleep = std::chrono::milliseconds(100);

/// Fine enough for ramps that look smooth and for the dead-man's bound; 100 times a second costs next to
/// nothing.
constexpr Duration kSafetyStep = std::chrono::milliseconds(10);
/// Commands done in one go, so that a step stays short.
constexpr std::size_t kCommandsAtOnce = 32;

}  // namespace

EngineCore::EngineCore(Scheduler& scheduler, LinkProvider& links, const EngineOptions& options)
    : scheduler_(scheduler), links_(links), options_(options) {
    publishIfChanged();
}

EngineCore::~EngineCore() {
    endSessions();
}

void EngineCore::start() {
    lookedAt_ = scheduler_.now();
    asleep_ = options_.timeAsleep();
    step();
}

void EngineCore::step() {
    const TimePoint now = scheduler_.now();
    stepTimer_ = scheduler_.callAt(now + kSafetyStep, [this] { step(); });
    takeCommands();
    if (answersLost_ > 0)
        note({EngineNote::Kind::AnswersLost, now, StopReason::None, std::exchange(answersLost_, 0), {}});
    const bool fresh = flows_.heartbeat.fresh(now, options_.heartbeatLimit);
    if (std::exchange(heartbeatFresh_, fresh) != fresh) ++ownVersion_;
    for (const auto& slot : sessions_) {
        slot->session().step(now, fresh);
        if (slot->readSim(now)) ++ownVersion_;
    }
    // Sessions latch STOP themselves where a robot or link is lost; the others hear of it here.
    latchChanged();
    publishIfChanged();
}

void EngineCore::noticePause() {
    const TimePoint now = scheduler_.now();
    const bool paused = now - std::exchange(lookedAt_, now) > options_.heartbeatLimit;
    const Duration asleep = options_.timeAsleep();
    const bool slept = asleep - std::exchange(asleep_, asleep) > kShortestSleep;
    if (!paused && !slept) return;
    const bool active = std::any_of(sessions_.begin(), sessions_.end(),
                                    [](const auto& slot) { return slot->session().active(); });
    if (slept && active) flows_.stop.set(StopReason::Suspend);
    // A sign of life from before the pause, or from a thread that was woken first, says nothing about it.
    flows_.heartbeat.withdraw();
    for (const auto& slot : sessions_)
        slot->session().step(now, false);
}

void EngineCore::wake() {
    if (woken_.exchange(true)) return;
    scheduler_.post([this, alive = std::weak_ptr(alive_)] {
        if (alive.expired()) return;
        woken_ = false;
        takeCommands();
    });
}

void EngineCore::takeCommands() {
    noticePause();
    for (std::size_t left = kCommandsAtOnce; left > 0; --left) {
        // A STOP comes before whatever waits here.
        latchChanged();
        auto command = flows_.commands.tryPop();
        if (!command) return;
        execute(*command);
    }
    wake();
}

std::size_t EngineCore::find(SessionId id) const {
    const auto found =
        std::find_if(sessions_.begin(), sessions_.end(), [id](const auto& slot) { return slot->id() == id; });
    return static_cast<std::size_t>(found - sessions_.begin());
}

void EngineCore::execute(Command& command) {
    if (ending_) {
        answer({command.id, command.session, fail(Errc::NotConnected)});
        return;
    }
    if (const auto* body = std::get_if<Connect>(&command.body)) {
        answer({command.id, command.session, connect(command.session, body->uri)});
        return;
    }
    if (std::holds_alternative<Discover>(command.body)) {
        discover(command.id);
        return;
    }
    const std::size_t at = find(command.session);
    if (at == sessions_.size()) {
        answer({command.id, command.session, fail(Errc::NotConnected)});
    } else if (std::holds_alternative<Disconnect>(command.body)) {
        disconnect(command.id, at);
    } else if (const auto* sim = std::get_if<SimPerform>(&command.body)) {
        answer({command.id, command.session, sessions_[at]->performSim(*sim)});
    } else if (const auto* system = std::get_if<SystemCommand>(&command.body)) {
        sessions_[at]->session().execute(command.id, *system);
    }
}

Result<void> EngineCore::connect(SessionId id, const LinkUri& uri) {
    if (id == 0 || find(id) != sessions_.size()) return fail(Errc::BadArgument, "session");
    auto slot = std::make_unique<SessionSlot>(
        id, uri, [this](EngineEvent event) { flows_.events.append(std::move(event)); },
        [this](Answer given) { answer(std::move(given)); });
    auto opened = slot->open(links_, scheduler_, flows_.stop);
    if (!opened) return opened;
    sessions_.push_back(std::move(slot));
    ++ownVersion_;
    note({EngineNote::Kind::SessionOpened, scheduler_.now(), StopReason::None, 0, toString(uri)}, id);
    return {};
}

void EngineCore::disconnect(CommandId id, std::size_t at) {
    SessionSlot* slot = sessions_[at].get();
    // What it counted is kept, so that the sum of all versions never comes to what was published before.
    ownVersion_ += slot->session().version() + 1;
    const TimerId deadline = scheduler_.callAfter(options_.shutdownLimit, [this, slot] { closed(slot); });
    closing_.push_back({std::move(sessions_[at]), id, deadline});
    sessions_.erase(sessions_.begin() + static_cast<std::ptrdiff_t>(at));
    slot->session().shutdown([this, slot] { closed(slot); });
}

void EngineCore::closed(const SessionSlot* slot) {
    const auto found = std::find_if(closing_.begin(), closing_.end(), [slot](const Closing& closing) {
        return closing.slot.get() == slot && closing.command;
    });
    if (found == closing_.end()) return;
    scheduler_.cancel(found->deadline);
    note({EngineNote::Kind::SessionClosed, scheduler_.now(), StopReason::None, 0, {}}, slot->id());
    answer({std::exchange(found->command, 0), slot->id(), {}});
    oneShutDown();
    // Not from inside its own call: the slot goes when that has returned.
    scheduler_.post([this, slot, alive = std::weak_ptr(alive_)] {
        if (alive.expired()) return;
        std::erase_if(closing_, [slot](const Closing& closing) { return closing.slot.get() == slot; });
    });
}

void EngineCore::discover(CommandId id) {
    links_.discover(scheduler_, [this, id, alive = std::weak_ptr(alive_)](FoundHardware found) {
        if (alive.expired()) return;
        found_ = std::move(found.devices);
        ports_ = std::move(found.ports);
        discovered_ = true;
        ++ownVersion_;
        answer({id, 0, {}});
        publishIfChanged();
    });
}

void EngineCore::latchChanged() {
    // By count: a STOP that was re-armed before this thread came to look halts everything all the same.
    const std::uint64_t stops = flows_.stop.stops();
    const std::uint64_t presses = flows_.stop.presses();
    if (std::exchange(pressesSeen_, presses) != presses) {
        for (const auto& slot : sessions_)
            slot->session().halt();
    }
    if (std::exchange(stopsSeen_, stops) != stops) {
        stopTold_ = true;
        tellLatch(EngineNote::Kind::Stopped, flows_.stop.lastReason());
    }
    if (stopTold_ && !flows_.stop.isSet()) {
        stopTold_ = false;
        tellLatch(EngineNote::Kind::Rearmed, StopReason::None);
    }
}

void EngineCore::tellLatch(EngineNote::Kind kind, StopReason reason) {
    ++ownVersion_;
    const TimePoint now = scheduler_.now();
    for (const auto& slot : sessions_)
        slot->mark(kind == EngineNote::Kind::Stopped ? MarkKind::Stop : MarkKind::Rearmed, now,
                   static_cast<float>(reason));
    note({kind, now, reason, 0, {}});
    publishIfChanged();
}

void EngineCore::answer(Answer given) {
    if (!flows_.answers.tryPush(std::move(given))) ++answersLost_;
}

void EngineCore::note(EngineNote told, SessionId session) {
    flows_.events.append({session, std::move(told)});
}

std::uint64_t EngineCore::versions() const {
    std::uint64_t version = ownVersion_;
    for (const auto& slot : sessions_)
        version += slot->session().version();
    return version;
}

void EngineCore::publishIfChanged() {
    const std::uint64_t version = versions();
    if (version == publishedVersion_) return;
    publishedVersion_ = version;
    EngineSnapshot snapshot;
    snapshot.time = scheduler_.now();
    snapshot.stop = flows_.stop.reason();
    snapshot.heartbeatFresh = heartbeatFresh_;
    snapshot.discovered = discovered_;
    snapshot.found = found_;
    snapshot.ports = ports_;
    snapshot.sessions.reserve(sessions_.size());
    for (const auto& slot : sessions_)
        snapshot.sessions.push_back(slot->snapshot());
    flows_.snapshots.publish(std::move(snapshot));
}

void EngineCore::shutdown(std::function<void()> done) {
    ending_ = true;
    shutDown_ = std::move(done);
    toShutDown_ = sessions_.size() + static_cast<std::size_t>(std::count_if(
                                         closing_.begin(), closing_.end(),
                                         [](const Closing& closing) { return closing.command != 0; }));
    if (toShutDown_ == 0) {
        std::exchange(shutDown_, {})();
        return;
    }
    shutdownDeadline_ = scheduler_.callAfter(options_.shutdownLimit, [this] {
        toShutDown_ = 1;
        oneShutDown();
    });
    for (const auto& slot : sessions_)
        slot->session().shutdown([this] { oneShutDown(); });
}

void EngineCore::oneShutDown() {
    if (!shutDown_ || --toShutDown_ > 0) return;
    scheduler_.cancel(std::exchange(shutdownDeadline_, 0));
    std::exchange(shutDown_, {})();
}

void EngineCore::endSessions() {
    scheduler_.cancel(std::exchange(stepTimer_, 0));
    scheduler_.cancel(std::exchange(shutdownDeadline_, 0));
    for (const Closing& closing : closing_)
        scheduler_.cancel(closing.deadline);
    sessions_.clear();
    closing_.clear();
}

}  // namespace kickstand
