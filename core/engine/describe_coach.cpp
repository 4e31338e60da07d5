#include "core/engine/describe_coach.h"

#include <QCoreApplication>
#include <QStringList>
#include <cstdlib>

#include "core/engine/describe_facts.h"

namespace kickstand {
namespace {

using coach::EventKind;
using coach::wire::Opcode;

struct CoachWords {
    Q_DECLARE_TR_FUNCTIONS(CoachWords)
};

EventText information(QString text) {
    return {std::move(text), Severity::Information};
}
EventText warning(QString text) {
    return {std::move(text), Severity::Warning};
}
EventText danger(QString text) {
    return {std::move(text), Severity::Danger};
}

QString hex16(std::int64_t value) {
    return QStringLiteral("0x") + QStringLiteral("%1").arg(value & 0xFFFF, 4, 16, QLatin1Char('0')).toUpper();
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

EventText linkEvent(const coach::Event& event) {
    switch (event.kind) {
        case EventKind::Connected:
            return information(
                CoachWords::tr("connected: a radio module answers, its address is %1 (%2)")
                    .arg(hex16(event.code), describeAddress(static_cast<std::uint16_t>(event.code))));
        case EventKind::NoModule:
            return warning(CoachWords::tr("the port is open, but no radio module in API mode answers"));
        case EventKind::Disconnected:
            return information(CoachWords::tr("disconnected"));
        case EventKind::LinkLost:
            return danger(
                CoachWords::tr("link lost: a boat that was driven stops by its own timer, within "
                               "a second of its last velocity"));
        case EventKind::LinkFailed:
            return danger(CoachWords::tr("link failed: %1").arg(reason(event.code, event.text)));
        case EventKind::ModuleReset:
            return warning(CoachWords::tr("the radio module has started anew"));
        default:
            return information(CoachWords::tr("waiting for the serial port to be plugged in"));
    }
}

EventText radioEvent(const coach::Event& event) {
    switch (event.kind) {
        case EventKind::RadioFound:
            return information(CoachWords::tr("radio module found, at %1 baud").arg(event.code));
        case EventKind::RadioNotFound:
            return warning(CoachWords::tr("no radio module was found at any speed"));
        case EventKind::RadioApplied:
            return information(
                CoachWords::tr("radio module set and read back: %1 (%2), changes: %3")
                    .arg(hex16(event.code), describeAddress(static_cast<std::uint16_t>(event.code)))
                    .arg(event.previous));
        default:
            return danger(
                CoachWords::tr("the radio module could not be set: %1").arg(reason(event.code, event.text)));
    }
}

EventText pairingEvent(const coach::Event& event) {
    switch (event.kind) {
        case EventKind::CoachStarted:
            return information(CoachWords::tr("COACH %1 starts up").arg(event.team));
        case EventKind::TowrpStarted:
            return information(CoachWords::tr("TOWRP %1 wakes").arg(event.team));
        case EventKind::RoleEnded:
            return information(CoachWords::tr("no COACH or TOWRP is played any more"));
        case EventKind::BoatFound:
            return information(
                CoachWords::tr("TOWRP %1 is heard, with %2 dBm").arg(event.team).arg(event.code));
        case EventKind::PairingFailed:
            return static_cast<Errc>(event.code) == Errc::PairedElsewhere
                       ? warning(
                             CoachWords::tr("TOWRP %1 obeys COACH %2").arg(event.team).arg(event.previous))
                       : warning(CoachWords::tr("TOWRP %1 does not answer").arg(event.team));
        case EventKind::Paired:
            return information(CoachWords::tr("paired with team %1").arg(event.team));
        default:
            return warning(CoachWords::tr("not paired with team %1 any more: %2")
                               .arg(event.team)
                               .arg(describe(static_cast<coach::Unpairing>(event.code))));
    }
}

EventText pairedEvent(const coach::Event& event) {
    switch (event.kind) {
        case EventKind::MutinyStarted:
            return warning(CoachWords::tr("mutiny: three seconds to suppress it"));
        case EventKind::MutinyQuelled:
            return information(CoachWords::tr("mutiny quelled, morale %1").arg(event.code));
        case EventKind::MutinyLost:
            return warning(CoachWords::tr("the mutiny was not suppressed in time: the crew has the boat"));
        case EventKind::SuppressSent:
            return information(CoachWords::tr("Suppress Mutiny sent"));
        case EventKind::Jettisoned:
            return information(CoachWords::tr("crew jettisoned"));
        case EventKind::FreeDigital:
            return information(CoachWords::tr("free digital"));
        case EventKind::FreeAnalog:
            return information(CoachWords::tr("free analog: %1 %").arg(event.code));
        case EventKind::MoraleSet:
            return information(CoachWords::tr("morale %1").arg(event.code));
        case EventKind::BoatStopped:
            return warning(CoachWords::tr("no velocity for a second: the boat stops by itself"));
        default:
            return warning(CoachWords::tr("zero velocity sent to TOWRP %1").arg(event.team));
    }
}

QString levelText(int level, const QString& positive, const QString& negative) {
    const int percent = coach::wire::percentOf(level);
    return QStringLiteral("%1 % %2").arg(std::abs(percent)).arg(percent < 0 ? negative : positive);
}

}  // namespace

QString describe(coach::LinkState state) {
    using coach::LinkState;
    switch (state) {
        case LinkState::Idle:
            return CoachWords::tr("not connected");
        case LinkState::Searching:
            return CoachWords::tr("waiting for the port");
        case LinkState::Opening:
            return CoachWords::tr("opening the port");
        case LinkState::Asking:
            return CoachWords::tr("asking the radio module");
        case LinkState::NoModule:
            return CoachWords::tr("no radio module in API mode");
        case LinkState::Setting:
            return CoachWords::tr("setting up the radio module");
        case LinkState::Running:
            return CoachWords::tr("radio module ready");
        case LinkState::Failed:
            return CoachWords::tr("failed");
    }
    return {};
}

QString describe(coach::CoachState state) {
    using coach::CoachState;
    switch (state) {
        case CoachState::Off:
            return CoachWords::tr("off");
        case CoachState::Startup:
            return CoachWords::tr("startup");
        case CoachState::NotPaired:
            return CoachWords::tr("not paired");
        case CoachState::Asserting:
            return CoachWords::tr("asserting command");
        case CoachState::Paired:
            return CoachWords::tr("paired");
    }
    return {};
}

QString describe(coach::TowrpState state) {
    using coach::TowrpState;
    switch (state) {
        case TowrpState::Off:
            return CoachWords::tr("off");
        case TowrpState::NotPaired:
            return CoachWords::tr("not paired");
        case TowrpState::Paired:
            return CoachWords::tr("paired");
        case TowrpState::Mutiny:
            return CoachWords::tr("mutiny");
    }
    return {};
}

QString describe(coach::TimerKind timer) {
    using coach::TimerKind;
    switch (timer) {
        case TimerKind::Startup:
            return CoachWords::tr("startup ends");
        case TimerKind::Assert:
        case TimerKind::Result:
            return CoachWords::tr("ask again");
        case TimerKind::Velocity:
            return CoachWords::tr("velocity");
        case TimerKind::MoraleReply:
            return CoachWords::tr("repeat velocity");
        case TimerKind::SuppressReply:
            return CoachWords::tr("repeat suppress");
        case TimerKind::Silence:
            return CoachWords::tr("not paired");
        case TimerKind::Mutiny:
            return CoachWords::tr("mutiny wins");
        case TimerKind::Available:
            return CoachWords::tr("available");
        case TimerKind::MoraleStep:
            return CoachWords::tr("morale may change");
    }
    return {};
}

QString describe(coach::Unpairing why) {
    using coach::Unpairing;
    switch (why) {
        case Unpairing::Silence:
            return CoachWords::tr("nothing was heard for five seconds");
        case Unpairing::Jettison:
            return CoachWords::tr("the crew was jettisoned");
        case Unpairing::Mutiny:
            return CoachWords::tr("the mutiny was not suppressed");
        case Unpairing::RoleEnded:
            return CoachWords::tr("ended here");
        case Unpairing::LinkLost:
            return CoachWords::tr("the link was lost");
    }
    return {};
}

QString describe(coach::ModuleMode mode) {
    using coach::ModuleMode;
    switch (mode) {
        case ModuleMode::Transparent:
            return CoachWords::tr("transparent");
        case ModuleMode::Api:
            return CoachWords::tr("API mode 1");
        case ModuleMode::ApiEscaped:
            return CoachWords::tr("API mode 2 (escaped)");
    }
    return {};
}

QString describeOutcome(const coach::TrafficEntry& sent) {
    if (!sent.outcome) return CoachWords::tr("on its way");
    switch (*sent.outcome) {
        case 0:
            // Nobody acknowledges what is meant for all.
            return sent.address == xbee::kBroadcast ? CoachWords::tr("sent") : CoachWords::tr("acknowledged");
        case 1:
            return CoachWords::tr("no acknowledgement");
        case 2:
            return CoachWords::tr("channel busy");
        case 3:
            return CoachWords::tr("purged");
        default:
            return CoachWords::tr("status %1").arg(*sent.outcome);
    }
}

QString describe(const coach::wire::Velocity& velocity) {
    QStringList parts;
    if (velocity.forward != 0)
        parts << levelText(velocity.forward, CoachWords::tr("forward"), CoachWords::tr("backward"));
    if (velocity.turn != 0)
        parts << levelText(velocity.turn, CoachWords::tr("counterclockwise"), CoachWords::tr("clockwise"));
    return parts.isEmpty() ? CoachWords::tr("stop") : parts.join(QStringLiteral(", "));
}

QString describe(const coach::wire::Message& message) {
    const int number = message.parameter < 0x80 ? message.parameter : message.parameter - 0x100;
    switch (message.opcode) {
        case Opcode::SuppressMutiny:
            return CoachWords::tr("Suppress Mutiny");
        case Opcode::AssertCommand:
            return CoachWords::tr("Assertion of Command, %1")
                .arg(message.parameter == 0 ? CoachWords::tr("red") : CoachWords::tr("blue"));
        case Opcode::Jettison:
            return CoachWords::tr("Jettison the Crew");
        case Opcode::Velocity:
            return CoachWords::tr("Velocity: %1").arg(describe(coach::wire::velocityOf(message.parameter)));
        case Opcode::FreeDigital:
            return CoachWords::tr("Free Digital");
        case Opcode::FreeAnalog:
            return CoachWords::tr("Free Analog: %1 %").arg(number);
        case Opcode::MutinyInProgress:
            return CoachWords::tr("Mutiny in Progress");
        case Opcode::Available:
            return CoachWords::tr("I Am Available");
        case Opcode::AssertionResult:
            return CoachWords::tr("Assertion of Command Result: COACH %1").arg(message.parameter);
        case Opcode::UpdateMorale:
            return CoachWords::tr("Update Morale: %1").arg(number);
    }
    return {};
}

QString describeAddress(std::uint16_t address) {
    if (address == 0xFFFF) return CoachWords::tr("all");
    const int team = coach::wire::teamOf(address);
    switch (coach::wire::roleOf(address).value_or(static_cast<coach::wire::Role>(255))) {
        case coach::wire::Role::Coach:
            return CoachWords::tr("COACH %1").arg(team);
        case coach::wire::Role::Towrp:
            return CoachWords::tr("TOWRP %1").arg(team);
    }
    return hex16(address);
}

EventText describeCoachEvent(const coach::Event& event) {
    switch (event.kind) {
        case EventKind::Connected:
        case EventKind::NoModule:
        case EventKind::Disconnected:
        case EventKind::LinkLost:
        case EventKind::LinkFailed:
        case EventKind::Waiting:
        case EventKind::ModuleReset:
            return linkEvent(event);
        case EventKind::RadioFound:
        case EventKind::RadioNotFound:
        case EventKind::RadioApplied:
        case EventKind::RadioFailed:
            return radioEvent(event);
        case EventKind::CoachStarted:
        case EventKind::TowrpStarted:
        case EventKind::RoleEnded:
        case EventKind::BoatFound:
        case EventKind::PairingFailed:
        case EventKind::Paired:
        case EventKind::Unpaired:
            return pairingEvent(event);
        default:
            return pairedEvent(event);
    }
}

}  // namespace kickstand
