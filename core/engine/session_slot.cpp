#include "core/engine/session_slot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "core/engine/event_marks.h"

namespace kickstand {
namespace {

/// Often enough to be watched by a person.
constexpr Duration kSimReadEvery = std::chrono::milliseconds(100);
/// Finer steps than these of a quantity are no news.
constexpr double kSimSteps = 1000;

}  // namespace

SessionSlot::SessionSlot(SessionId id, LinkUri uri, std::function<void(EngineEvent)> event,
                         std::function<void(Answer)> answer)
    : id_(id),
      uri_(std::move(uri)),
      event_(std::move(event)),
      answer_(std::move(answer)),
      telemetry_(std::make_shared<TelemetryStore>()) {}

Result<void> SessionSlot::open(LinkProvider& links, Scheduler& scheduler, StopLatch& stop) {
    const SessionEnvironment environment{scheduler, stop, *this,
                                         [this](SystemEvent event) {
                                             markEvent(event);
                                             event_(EngineEvent{id_, std::move(event)});
                                         },
                                         [this](CommandId id, Result<void> result) {
                                             answer_(Answer{id, id_, std::move(result)});
                                         }};
    auto made = makeSession(uri_, links, environment);
    if (!made) return fail(made.error());
    made_ = std::move(*made);
    telemetry_ = std::make_shared<TelemetryStore>(made_.telemetry);
    made_.session->start();
    return {};
}

Result<void> SessionSlot::performSim(const SimPerform& command) {
    if (made_.sim == nullptr) return fail(Errc::Unsupported, command.action);
    simReadAt_ = {};
    return made_.sim->perform(command.action, command.unit, command.value);
}

bool SessionSlot::readSim(TimePoint now) {
    if (made_.sim == nullptr || now - simReadAt_ < kSimReadEvery) return false;
    simReadAt_ = now;
    std::vector<SimReading> readings;
    const std::vector<int> units = made_.sim->units();
    for (const SimAction& action : made_.sim->actions()) {
        for (const int unit : action.perUnit ? units : std::vector{-1}) {
            if (const auto value = made_.sim->value(action.name, unit))
                readings.push_back({action.name, unit, std::round(*value * kSimSteps) / kSimSteps});
        }
    }
    return std::exchange(simReadings_, std::move(readings)) != simReadings_;
}

void SessionSlot::mark(MarkKind kind, TimePoint time, float value) {
    telemetry_->mark(Mark{time, kind, kNoUnit, value});
}

void SessionSlot::markEvent(const SystemEvent& event) {
    if (const auto mark = markOf(event)) telemetry_->mark(*mark);
}

SessionSnapshot SessionSlot::snapshot() const {
    SessionSnapshot snapshot;
    snapshot.id = id_;
    snapshot.uri = uri_;
    if (made_.sim != nullptr) {
        snapshot.simActions = made_.sim->actions();
        snapshot.simUnits = made_.sim->units();
        snapshot.simReadings = simReadings_;
    }
    snapshot.system = made_.session->snapshot();
    snapshot.telemetry = telemetry_;
    return snapshot;
}

void SessionSlot::sample(SignalId signal, TimePoint time, float value) {
    telemetry_->append(signal, time, value);
}

void SessionSlot::gap(SignalId signal, TimePoint time) {
    if (TimeSeries* series = telemetry_->series(signal)) series->gap(time);
}

}  // namespace kickstand
