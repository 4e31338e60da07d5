#include "ui/shell/engine_client.h"

#include <chrono>
#include <utility>

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

constexpr auto kPollInterval = 16ms;
constexpr auto kHeartbeatInterval = 50ms;

}  // namespace

EngineClient::EngineClient(Engine& engine, QObject* parent)
    : QObject(parent), engine_(engine), snapshot_(engine.snapshot()), stopped_(engine.isStopped()) {
    poll_.setTimerType(Qt::PreciseTimer);
    heartbeat_.setTimerType(Qt::PreciseTimer);
    connect(&poll_, &QTimer::timeout, this, &EngineClient::poll);
    connect(&heartbeat_, &QTimer::timeout, this, [this] { engine_.heartbeat(); });
    engine_.heartbeat();
    poll_.start(kPollInterval);
    heartbeat_.start(kHeartbeatInterval);
}

const SessionSnapshot* EngineClient::session(SessionId id) const {
    for (const SessionSnapshot& session : snapshot_->sessions) {
        if (session.id == id) return &session;
    }
    return nullptr;
}

void EngineClient::submit(SessionId session, CommandBody body, QObject* context, Answered answered) {
    const auto* command = std::get_if<SystemCommand>(&body);
    const bool toSystem = command != nullptr;
    const bool moves = toSystem && mayMove(*command);
    const Result<CommandId> id = engine_.submit(session, std::move(body));
    Pending pending{context, context != nullptr, toSystem, moves, std::move(answered)};
    if (id) {
        waiting_ += toSystem ? 1 : 0;
        waitingToMove_ += moves ? 1 : 0;
        pending_.emplace(*id, std::move(pending));
        return;
    }
    // An answer never comes from inside the call that asked for it.
    QTimer::singleShot(0, this, [this, error = id.error(), pending = std::move(pending)] {
        emit refused(error);
        const bool gone = pending.hasContext && pending.context == nullptr;
        if (pending.answered && !gone) pending.answered(fail(error));
    });
}

Result<SessionId> EngineClient::connectTo(const LinkUri& uri) {
    return engine_.connect(uri);
}

void EngineClient::stop(StopReason reason) {
    if (!engine_.isStopped()) asked_ = reason;
    engine_.stop(reason);
    noticeStop();
}

void EngineClient::rearm() {
    engine_.rearm();
    noticeStop();
}

StopReason EngineClient::stopReason() const {
    if (!engine_.isStopped()) return StopReason::None;
    if (snapshot_->stop != StopReason::None) return snapshot_->stop;
    return asked_ != StopReason::None ? asked_ : StopReason::Person;
}

void EngineClient::poll() {
    const std::uint64_t version = engine_.snapshotVersion();
    const bool fresh = version != version_;
    if (fresh) {
        version_ = version;
        snapshot_ = engine_.snapshot();
    }
    noticeStop();
    if (fresh) emit snapshotChanged();
    takeEvents();
    takeAnswers();
}

void EngineClient::takeAnswers() {
    for (Answer& answer : engine_.takeAnswers()) {
        // Taken out first: whoever is called may submit again.
        auto node = pending_.extract(answer.id);
        if (!answer.result) emit refused(answer.result.error());
        if (node.empty()) {
            // Only connecting is not handed in by submit().
            if (!answer.result) emit connectRefused(answer.session, answer.result.error());
            continue;
        }
        const Pending& pending = node.mapped();
        waiting_ -= pending.toSystem ? 1 : 0;
        waitingToMove_ -= pending.moves ? 1 : 0;
        if (!pending.answered) continue;
        if (!pending.hasContext || pending.context != nullptr) pending.answered(answer.result);
    }
}

void EngineClient::takeEvents() {
    auto read = engine_.readEvents(cursor_);
    if (read.events.empty() && read.lost == 0) return;
    std::vector<EngineEvent> events;
    events.reserve(read.events.size());
    for (auto& event : read.events)
        events.push_back(std::move(event.value));
    emit eventsArrived(events, read.lost);
}

void EngineClient::noticeStop() {
    const bool stopped = engine_.isStopped();
    if (stopped == stopped_) return;
    stopped_ = stopped;
    if (!stopped) asked_ = StopReason::None;
    emit stopChanged();
}

}  // namespace kickstand::ui
