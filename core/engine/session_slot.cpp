#include "core/engine/session_slot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace kickstand {
namespace {

/// Often enough to be watched by a person.
constexpr Duration kSimReadEvery = std::chrono::milliseconds(100);
/// Finer steps than these of a quantity are no news.
constexpr double kSimSteps = 1000;

std::optional<Mark> markOf(const thunderbots::Event& event) {
    using Kind = thunderbots::EventKind;
    Mark mark;
    mark.time = event.time;
    if (event.robot >= 0) mark.unit = static_cast<std::uint16_t>(event.robot);
    switch (event.kind) {
        case Kind::KickGiven:
            mark.kind = MarkKind::Kick;
            mark.value = static_cast<float>(std::max(event.code, event.previous));
            return mark;
        case Kind::Autokick:
            mark.kind = MarkKind::Autokick;
            return mark;
        case Kind::DongleFault:
            mark.kind = MarkKind::DeviceError;
            mark.value = static_cast<float>(event.code);
            return mark;
        case Kind::Connected:
            mark.kind = MarkKind::LinkUp;
            return mark;
        case Kind::LinkLost:
        case Kind::Disconnected:
            mark.kind = MarkKind::LinkDown;
            return mark;
        case Kind::RobotFound:
            mark.kind = MarkKind::UnitHeard;
            return mark;
        case Kind::RobotLost:
            mark.kind = MarkKind::UnitLost;
            return mark;
        default:
            return std::nullopt;
    }
}

std::optional<Mark> markOf(const smartdevice::Event& event) {
    using Kind = smartdevice::EventKind;
    Mark mark;
    mark.time = event.time;
    if (event.robot >= 0) mark.unit = static_cast<std::uint16_t>(event.robot);
    switch (event.kind) {
        case Kind::DeviceFound:
        case Kind::DeviceBack:
            mark.kind = MarkKind::UnitHeard;
            return mark;
        case Kind::DeviceLost:
            mark.kind = MarkKind::UnitLost;
            return mark;
        case Kind::DeviceError:
            mark.kind = MarkKind::DeviceError;
            mark.value = static_cast<float>(event.code);
            return mark;
        default:
            return std::nullopt;
    }
}

std::optional<Mark> markOf(const motionplan::Event& event) {
    using Kind = motionplan::EventKind;
    Mark mark;
    mark.time = event.time;
    switch (event.kind) {
        case Kind::Connected:
            mark.kind = MarkKind::LinkUp;
            return mark;
        case Kind::LinkLost:
        case Kind::Disconnected:
            mark.kind = MarkKind::LinkDown;
            return mark;
        case Kind::Refused:
            mark.kind = MarkKind::DeviceError;
            mark.value = static_cast<float>(event.code);
            return mark;
        default:
            return std::nullopt;
    }
}

std::optional<Mark> markOf(const coach::Event& event) {
    using Kind = coach::EventKind;
    Mark mark;
    mark.time = event.time;
    if (event.team >= 0) mark.unit = static_cast<std::uint16_t>(event.team);
    switch (event.kind) {
        case Kind::Connected:
            mark.kind = MarkKind::LinkUp;
            return mark;
        case Kind::LinkLost:
        case Kind::Disconnected:
            mark.kind = MarkKind::LinkDown;
            return mark;
        case Kind::Paired:
            mark.kind = MarkKind::UnitHeard;
            return mark;
        case Kind::Unpaired:
            mark.kind = MarkKind::UnitLost;
            return mark;
        default:
            return std::nullopt;
    }
}

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
    const auto mark = std::visit([](const auto& own) { return markOf(own); }, event);
    if (mark) telemetry_->mark(*mark);
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
