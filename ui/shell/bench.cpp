#include "ui/shell/bench.h"

#include <utility>

#include "ui/shell/system_view.h"

namespace kickstand::ui {

Bench::Bench(EngineClient& client, const SystemRegistry& systems, QSettings& settings, QObject* parent)
    : QObject(parent), client_(client), systems_(systems), settings_(settings) {
    connect(&client_, &EngineClient::snapshotChanged, this, &Bench::follow);
    connect(&client_, &EngineClient::connectRefused, this, &Bench::giveUp);
}

const SystemView* Bench::view() const {
    const SessionSnapshot* shown = session();
    return shown == nullptr ? nullptr : systems_.viewOf(shown->system);
}

void Bench::show(SessionId id) {
    if (id == current_) return;
    current_ = id;
    emit sessionChanged();
    emit changed();
}

bool Bench::isActive() const {
    if (client_.hasPending()) return true;
    for (const SessionSnapshot& session : client_.snapshot().sessions) {
        const SystemView* view = systems_.viewOf(session.system);
        if (view != nullptr && view->isActive(session.system)) return true;
    }
    return false;
}

void Bench::submit(CommandBody body, QObject* context, EngineClient::Answered answered) {
    client_.submit(current_, std::move(body), context, std::move(answered));
}

void Bench::connectTo(const LinkUri& uri) {
    disconnectAll();
    connectBeside(uri);
}

void Bench::connectBeside(const LinkUri& uri) {
    const Result<SessionId> id = client_.connectTo(uri);
    if (id) {
        awaited_ = *id;
        emit changed();
    } else {
        emit connectRefused(id.error());
    }
}

void Bench::giveUp(SessionId id, const Error& error) {
    if (id == awaited_) awaited_ = 0;
    emit connectRefused(error);
    emit changed();
}

void Bench::disconnectAll() {
    // One that was asked for a moment ago may not be in the snapshot yet.
    if (awaited_ != 0 && client_.session(awaited_) == nullptr) client_.submit(awaited_, Disconnect{});
    awaited_ = 0;
    for (const SessionSnapshot& session : client_.snapshot().sessions)
        client_.submit(session.id, Disconnect{});
}

void Bench::follow() {
    const auto& sessions = client_.snapshot().sessions;
    if (awaited_ != 0 && client_.session(awaited_) != nullptr) {
        current_ = std::exchange(awaited_, 0);
        emit sessionChanged();
    } else if (client_.session(current_) == nullptr && (current_ != 0 || !sessions.empty())) {
        const SessionId next = sessions.empty() ? 0 : sessions.front().id;
        if (next != current_) {
            current_ = next;
            emit sessionChanged();
        }
    }
    emit changed();
}

}  // namespace kickstand::ui
