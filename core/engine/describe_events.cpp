#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/engine/describe.h"
#include "core/engine/describe_check.h"
#include "core/engine/describe_coach.h"
#include "core/engine/describe_facts.h"
#include "core/engine/describe_fault.h"
#include "core/engine/describe_flash.h"
#include "core/engine/describe_motionplan.h"
#include "core/engine/describe_parameters.h"
#include "core/engine/describe_smartdevice.h"
#include "core/thunderbots/wire/readings.h"
#include "core/thunderbots/wire/test_mode.h"

namespace kickstand {
namespace {

namespace wire = thunderbots::wire;
using thunderbots::EventKind;

struct EventWords {
    Q_DECLARE_TR_FUNCTIONS(EventWords)
};

using Text = std::optional<EventText>;

EventText information(QString text) {
    return {std::move(text), Severity::Information};
}
EventText warning(QString text) {
    return {std::move(text), Severity::Warning};
}
EventText danger(QString text) {
    return {std::move(text), Severity::Danger};
}

QString battery(double volts) {
    return EventWords::tr("%1 V").arg(volts, 0, 'f', 1);
}
QString capacitor(double volts) {
    return EventWords::tr("%1 V").arg(volts, 0, 'f', 0);
}
QString endpoint(std::int64_t address) {
    return QStringLiteral("0x%1").arg(address & 0xFF, 2, 16, QLatin1Char('0'));
}

/// What an error says, to be put behind a colon.
QString reason(std::int64_t code, const std::string& detail = {}) {
    Error error;
    error.code = static_cast<Errc>(code);
    error.detail = detail;
    QString what = describe(error).what;
    if (what.endsWith(QLatin1Char('.'))) what.chop(1);
    return what;
}

/// A state that an event names by number: numbers that do not exist are shown as such.
template <class State>
QString stateText(std::int64_t code) {
    const QString text = code < 0 || code > 255 ? QString() : describe(static_cast<State>(code));
    return text.isEmpty() ? QString::number(code) : text;
}

Text linkEvent(const thunderbots::Event& event) {
    switch (event.kind) {
        case EventKind::Connected:
            return information(EventWords::tr("connected, all robots told to brake"));
        case EventKind::Disconnected:
            return information(EventWords::tr("disconnected"));
        case EventKind::LinkLost:
            return danger(event.text.empty()
                              ? EventWords::tr("link lost: the device was unplugged or is without power")
                              : EventWords::tr("link lost: %1").arg(QString::fromStdString(event.text)));
        case EventKind::LinkFailed:
            return danger(EventWords::tr("link failed: %1").arg(reason(event.code, event.text)));
        case EventKind::Waiting:
            return information(EventWords::tr("waiting for a device to be plugged in"));
        case EventKind::EmergencyStop: {
            const QString text =
                EventWords::tr("emergency stop: %1, before: %2")
                    .arg(stateText<wire::EStop>(event.code), stateText<wire::EStop>(event.previous));
            return event.code == static_cast<int>(wire::EStop::Run) ? information(text) : warning(text);
        }
        case EventKind::Radios: {
            const QString text = EventWords::tr("radios: %1").arg(stateText<wire::RadioState>(event.code));
            return event.code > static_cast<int>(wire::RadioState::Running) ? danger(text)
                                                                            : information(text);
        }
        case EventKind::Channels:
            return information(
                EventWords::tr("radio channels: %1 and %2").arg(event.code).arg(event.previous));
        default:
            return {};
    }
}

Text robotEvent(const thunderbots::Event& event) {
    switch (event.kind) {
        case EventKind::RobotFound:
            return information(EventWords::tr("heard"));
        case EventKind::RobotLost:
            if (event.value >= wire::kCapacitorLive_V)
                return danger(EventWords::tr("lost with %1 on its capacitor: treat as live")
                                  .arg(capacitor(event.value)));
            return warning(EventWords::tr("lost"));
        case EventKind::BatteryLow:
            if (event.code >= 2)
                return warning(EventWords::tr("battery at its end: %1").arg(battery(event.value)));
            return warning(EventWords::tr("battery low: %1").arg(battery(event.value)));
        case EventKind::TestMode: {
            const auto testClass = wire::testClassFromNumber(
                static_cast<std::uint8_t>(std::clamp<std::int64_t>(event.code, 0, 255)));
            if (testClass == wire::TestClass::None)
                return information(EventWords::tr("test LEDs: normal lights"));
            const QString shown =
                testClass ? QString::fromLatin1(wire::name(*testClass)) : QString::number(event.code);
            if (!testClass || !wire::targetsOf(*testClass).any())
                return information(EventWords::tr("test LEDs: %1").arg(shown));
            return information(EventWords::tr("test LEDs: %1 %2").arg(shown).arg(event.previous));
        }
        case EventKind::ExperimentData:
            return information(EventWords::tr("experiment data: %1 of 256 bytes known").arg(event.code));
        case EventKind::WheelLimit: {
            const QString text =
                EventWords::tr("wheel limit ±%1, before: ±%2").arg(event.code).arg(event.previous);
            return event.code > event.previous ? warning(text) : information(text);
        }
        default:
            return {};
    }
}

EventText kickGiven(const thunderbots::Event& event) {
    QString text = EventWords::tr("kick given to the dongle: %1 / %2 µs").arg(event.code).arg(event.previous);
    const QString offset_us = QString::number(std::abs(event.value), 'f', 0);
    if (event.value > 0) text += EventWords::tr(", solenoid 2 later by %1 µs").arg(offset_us);
    if (event.value < 0) text += EventWords::tr(", solenoid 1 later by %1 µs").arg(offset_us);
    return information(text);
}

EventText dischargeEnded(const thunderbots::Event& event) {
    if (event.code == 0) return information(EventWords::tr("discharged to %1").arg(capacitor(event.value)));
    const QString text = EventWords::tr("discharge broken off at %1: %2")
                             .arg(capacitor(event.value), reason(event.code, event.text));
    if (event.value < wire::kCapacitorLive_V) return warning(text);
    return danger(EventWords::tr("%1; treat as live").arg(text));
}

EventText kickMeasured(const thunderbots::Event& event) {
    const double before_V = static_cast<double>(event.previous) / 1000;
    const QString voltages = EventWords::tr("kick measured: capacitor %1 \u2192 %2")
                                 .arg(before_V, 0, 'f', 0)
                                 .arg(capacitor(event.value));
    if (event.code < 0) return information(voltages);
    return information(EventWords::tr("%1, charged again in %2 s")
                           .arg(voltages)
                           .arg(static_cast<double>(event.code) / 1000, 0, 'f', 1));
}

Text checkEvent(const thunderbots::Event& event) {
    switch (event.kind) {
        case EventKind::CheckStarted:
            return information(EventWords::tr("check begun, number of robots: %1").arg(event.code));
        case EventKind::RobotChecked: {
            const auto verdict = static_cast<thunderbots::CheckVerdict>(event.code);
            if (verdict == thunderbots::CheckVerdict::Passed)
                return information(EventWords::tr("checked: passed every step that was chosen"));
            return warning(EventWords::tr("checked: %1, steps that did not pass: %2")
                               .arg(describe(verdict))
                               .arg(event.previous));
        }
        case EventKind::CheckEnded:
            if (event.code == 0) return information(EventWords::tr("check done"));
            return warning(EventWords::tr("check ended early: %1").arg(reason(event.code, event.text)));
        default:
            return {};
    }
}

EventText sweepEnded(const thunderbots::Event& event) {
    if (event.code == 0)
        return information(EventWords::tr("sweep done, kicks given: %1").arg(event.previous));
    return warning(EventWords::tr("sweep ended early, kicks given: %1: %2")
                       .arg(event.previous)
                       .arg(reason(event.code, event.text)));
}

Text highVoltageEvent(const thunderbots::Event& event) {
    const bool on = event.code != 0;
    switch (event.kind) {
        case EventKind::Charged:
            return information(EventWords::tr("capacitor charged: %1").arg(capacitor(event.value)));
        case EventKind::KickGiven:
            return kickGiven(event);
        case EventKind::KickDropped:
            if (event.code == static_cast<int>(Errc::KickExpired))
                return warning(EventWords::tr("kick dropped: the dongle did not take it within 200 ms"));
            return warning(EventWords::tr("kick dropped: %1").arg(reason(event.code, event.text)));
        case EventKind::KickMeasured:
            return kickMeasured(event);
        case EventKind::SweepStarted:
            return information(EventWords::tr("sweep begun, kicks to give: %1").arg(event.code));
        case EventKind::SweepEnded:
            return sweepEnded(event);
        case EventKind::Autokick:
            return information(EventWords::tr("autokick fired, number %1").arg(event.code));
        case EventKind::AutokickArmed:
            return on ? warning(EventWords::tr("autokick armed"))
                      : information(EventWords::tr("autokick disarmed"));
        case EventKind::Charger:
            return information(on ? EventWords::tr("charger on") : EventWords::tr("charger off"));
        case EventKind::HighVoltage:
            return on ? warning(EventWords::tr("high voltage armed"))
                      : information(EventWords::tr("high voltage disarmed"));
        case EventKind::DischargeStarted:
            return information(EventWords::tr("discharging from %1").arg(capacitor(event.value)));
        case EventKind::DischargeEnded:
            return dischargeEnded(event);
        default:
            return {};
    }
}

QString dongleFaultText(std::int64_t code) {
    if (code < 0 || code > 255) return QString::number(code);
    return faultText(wire::dongleFault(static_cast<std::uint8_t>(code)));
}

EventText troubleEvent(const thunderbots::Event& event) {
    switch (event.kind) {
        case EventKind::DongleFault:
            return warning(EventWords::tr("the dongle reports: %1").arg(dongleFaultText(event.code)));
        case EventKind::DongleText:
            return information(EventWords::tr("the dongle says: %1").arg(printable(event.text)));
        case EventKind::Malformed:
            return warning(EventWords::tr("unreadable data on endpoint %1, number of times %2: %3")
                               .arg(endpoint(event.code))
                               .arg(event.value, 0, 'f', 0)
                               .arg(printable(event.text)));
        case EventKind::Stalled:
            return warning(EventWords::tr("endpoint %1 stalled, in a row: %2")
                               .arg(endpoint(event.code))
                               .arg(event.value, 0, 'f', 0));
        default:
            return warning(EventWords::tr("something that this program has no words for"));
    }
}

EventText textOf(const thunderbots::Event& event) {
    for (const auto& group :
         {linkEvent, robotEvent, highVoltageEvent, checkEvent, describeParameterEvent, describeFlashEvent}) {
        if (auto text = group(event)) return *std::move(text);
    }
    return troubleEvent(event);
}

EventText textOf(const motionplan::Event& event) {
    return describeMotionplanEvent(event);
}

EventText textOf(const coach::Event& event) {
    return describeCoachEvent(event);
}

EventText textOf(const smartdevice::Event& event) {
    return describeSmartDeviceEvent(event);
}

EventText textOf(const EngineNote& note) {
    switch (note.kind) {
        case EngineNote::Kind::Stopped:
            return danger(EventWords::tr("STOP: %1").arg(describe(note.reason)));
        case EngineNote::Kind::Rearmed:
            return warning(EventWords::tr("re-armed: what was stopped can move again"));
        case EngineNote::Kind::AnswersLost:
            return warning(
                EventWords::tr("answers to commands that nobody fetched in time and that are lost: %1")
                    .arg(note.count));
        case EngineNote::Kind::SessionOpened:
            return information(EventWords::tr("session opened: %1").arg(printable(note.text)));
        case EngineNote::Kind::SessionClosed:
            return information(EventWords::tr("session closed"));
    }
    return troubleEvent({});
}

EventText textOf(const SystemEvent& event) {
    return std::visit([](const auto& one) { return textOf(one); }, event);
}

int robotIn(const EngineNote&) {
    return -1;
}
template <class Event>
int robotIn(const Event& event) {
    return event.robot;
}
int robotIn(const thunderbots::Event& event) {
    if (event.kind != EventKind::DongleFault) return event.robot;
    // The dongle tells of some robots by its codes alone.
    const wire::Fault fault = wire::dongleFault(static_cast<std::uint8_t>(event.code));
    return fault.subject == wire::FaultSubject::Robot ? fault.index : event.robot;
}
int robotIn(const coach::Event&) {
    return -1;
}
int robotIn(const SystemEvent& event) {
    return std::visit([](const auto& one) { return robotIn(one); }, event);
}
template <class Event>
QString aboutIn(const Event& event) {
    const int robot = robotIn(event);
    return robot < 0 ? QString() : EventWords::tr("robot %1").arg(robot);
}
QString aboutIn(const smartdevice::Event& event) {
    return event.robot < 0 ? QString()
                           : QStringLiteral("%1 %2").arg(printable(event.device)).arg(event.robot);
}
QString aboutIn(const SystemEvent& event) {
    return std::visit([](const auto& one) { return aboutIn(one); }, event);
}
TimePoint timeIn(const EngineNote& note) {
    return note.time;
}
TimePoint timeIn(const SystemEvent& event) {
    return std::visit([](const auto& one) { return one.time; }, event);
}

}  // namespace

EventText describe(const EngineEvent& event) {
    return std::visit([](const auto& body) { return textOf(body); }, event.body);
}

int robotOf(const EngineEvent& event) {
    return std::visit([](const auto& body) { return robotIn(body); }, event.body);
}

QString aboutOf(const EngineEvent& event) {
    return std::visit([](const auto& body) { return aboutIn(body); }, event.body);
}

TimePoint timeOf(const EngineEvent& event) {
    return std::visit([](const auto& body) { return timeIn(body); }, event.body);
}

}  // namespace kickstand
