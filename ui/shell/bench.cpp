#include "ui/shell/bench.h"

#include <QSettings>
#include <utility>

namespace kickstand::ui {

namespace {

/// Before the quantity.
constexpr QLatin1String kUnitSettings("units/");

}  // namespace

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

bool Bench::isMoving() const {
    return client_.hasMotionPending() || any(&SystemView::isMoving);
}

bool Bench::isActive() const {
    return client_.hasMotionPending() || any(&SystemView::isActive);
}

bool Bench::any(bool (SystemView::*holds)(const SystemSnapshot&) const) const {
    for (const SessionSnapshot& session : client_.snapshot().sessions) {
        const SystemView* view = systems_.viewOf(session.system);
        if (view != nullptr && (view->*holds)(session.system)) return true;
    }
    return false;
}

void Bench::forgetLeftBehind() {
    leftBehind_.clear();
    emit changed();
}

void Bench::rememberHazards() {
    std::map<SessionId, std::vector<Hazard>> now;
    for (const SessionSnapshot& session : client_.snapshot().sessions) {
        const SystemView* view = systems_.viewOf(session.system);
        if (view != nullptr && !session.uri.isSimulated()) now[session.id] = view->hazards(session.system);
    }
    for (auto& [id, hazards] : hazards_) {
        if (now.contains(id)) continue;
        for (Hazard& hazard : hazards) {
            hazard.stale = true;
            leftBehind_.push_back(std::move(hazard));
        }
    }
    hazards_ = std::move(now);
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

int Bench::unitOf(const QString& quantity) const {
    return settings_.value(kUnitSettings + quantity, 0).toInt();
}

void Bench::chooseUnit(const QString& quantity, int unit) {
    settings_.setValue(kUnitSettings + quantity, unit);
    emit unitsChanged();
}

void Bench::goTo(const QString& place) {
    emit placeAsked(place.section(u'#', 0, 0), place.section(u'#', 1));
}

void Bench::follow() {
    rememberHazards();
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
