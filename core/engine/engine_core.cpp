#include "core/engine/engine_core.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

/// Fine enough for ramps that look smooth and for the dead-man's bound; 100 times a second costs next to
/// nothing.
constexpr Duration kSafetyStep = std::chrono::milliseconds(10);

}  // namespace

EngineCore::EngineCore(Scheduler& scheduler, LinkProvider& links, const EngineOptions& options)
    : scheduler_(scheduler), links_(links), options_(options) {
    publishIfChanged();
}

EngineCore::~EngineCore() {
    if (stepTimer_ != 0) scheduler_.cancel(stepTimer_);
}

void EngineCore::start() {
    step();
}

void EngineCore::step() {
    const TimePoint now = scheduler_.now();
    stepTimer_ = scheduler_.callAt(now + kSafetyStep, [this] { step(); });
    takeCommands();
    const bool fresh = flows_.heartbeat.fresh(now, options_.heartbeatLimit);
    if (std::exchange(heartbeatFresh_, fresh) != fresh) ++ownVersion_;
    for (const auto& slot : sessions_)
        slot->session().step(now, fresh);
    // Sessions latch STOP themselves where a robot or link is lost; the others hear of it here.
    latchChanged();
    publishIfChanged();
}

void EngineCore::takeCommands() {
    // What arrives while these are done waits for its own turn: a step stays short.
    for (std::size_t left = flows_.commands.size(); left > 0; --left) {
        if (auto command = flows_.commands.tryPop()) execute(*command);
    }
}

std::size_t EngineCore::find(SessionId id) const {
    const auto found =
        std::find_if(sessions_.begin(), sessions_.end(), [id](const auto& slot) { return slot->id() == id; });
    return static_cast<std::size_t>(found - sessions_.begin());
}

void EngineCore::execute(Command& command) {
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
    closing_.push_back(std::move(sessions_[at]));
    sessions_.erase(sessions_.begin() + static_cast<std::ptrdiff_t>(at));
    ++ownVersion_;
    SessionSlot* slot = closing_.back().get();
    slot->session().shutdown([this, slot, id] {
        const SessionId session = slot->id();
        note({EngineNote::Kind::SessionClosed, scheduler_.now(), StopReason::None, 0, {}}, session);
        answer({id, session, {}});
        // Not from inside its own call: the slot goes when that has returned.
        scheduler_.post([this, slot, alive = std::weak_ptr(alive_)] {
            if (alive.expired()) return;
            std::erase_if(closing_, [slot](const auto& closing) { return closing.get() == slot; });
        });
    });
}

void EngineCore::discover(CommandId id) {
    links_.discover(scheduler_, [this, id, alive = std::weak_ptr(alive_)](std::vector<FoundDevice> found) {
        if (alive.expired()) return;
        found_ = std::move(found);
        discovered_ = true;
        ++ownVersion_;
        answer({id, 0, {}});
        publishIfChanged();
    });
}

void EngineCore::latchChanged() {
    const bool stopped = flows_.stop.isSet();
    if (stopped == stopSeen_) return;
    stopSeen_ = stopped;
    ++ownVersion_;
    const StopReason reason = flows_.stop.reason();
    const TimePoint now = scheduler_.now();
    if (stopped) {
        for (const auto& slot : sessions_)
            slot->session().halt();
    }
    for (const auto& slot : sessions_)
        slot->mark(stopped ? MarkKind::Stop : MarkKind::Rearmed, now, static_cast<float>(reason));
    note({stopped ? EngineNote::Kind::Stopped : EngineNote::Kind::Rearmed, now, reason, 0, {}});
    publishIfChanged();
}

void EngineCore::answer(Answer given) {
    if (answersLost_ > 0 && flows_.answers.size() < flows_.answers.capacity())
        note({EngineNote::Kind::AnswersLost,
              scheduler_.now(),
              StopReason::None,
              std::exchange(answersLost_, 0),
              {}});
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
    snapshot.sessions.reserve(sessions_.size());
    for (const auto& slot : sessions_)
        snapshot.sessions.push_back(slot->snapshot());
    flows_.snapshots.publish(std::move(snapshot));
}

void EngineCore::shutdown(std::function<void()> done) {
    struct Waiting {
        std::size_t sessions = 0;
        std::function<void()> done;
        void finish() {
            if (const auto call = std::exchange(done, {})) call();
        }
    };
    const auto waiting = std::make_shared<Waiting>(Waiting{sessions_.size(), std::move(done)});
    if (sessions_.empty()) {
        waiting->finish();
        return;
    }
    scheduler_.callAfter(options_.shutdownLimit, [waiting] { waiting->finish(); });
    for (const auto& slot : sessions_) {
        slot->session().shutdown([waiting] {
            if (--waiting->sessions == 0) waiting->finish();
        });
    }
}

void EngineCore::endSessions() {
    scheduler_.cancel(std::exchange(stepTimer_, 0));
    sessions_.clear();
    closing_.clear();
}

}  // namespace kickstand
