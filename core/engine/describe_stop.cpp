#include "core/engine/describe_stop.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "core/engine/describe_findings.h"
#include "core/engine/describe_motionplan.h"
#include "core/motionplan/exchange.h"

namespace kickstand {
namespace {

struct StopWords {
    Q_DECLARE_TR_FUNCTIONS(StopWords)
};

QString told(const thunderbots::Snapshot& snapshot, bool linkLost) {
    if (linkLost)
        return StopWords::tr(
            "Robots may not have been told: they brake by themselves within 2.2 s. Look before "
            "you reach for them.");
    thunderbots::RobotMask unheard = 0;
    for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
        const thunderbots::RobotState& state = snapshot.robots[static_cast<std::size_t>(robot)];
        if (!state.live && state.feedback) unheard |= thunderbots::maskOf(robot);
    }
    const QString kick = StopWords::tr("A kick that the dongle already held may still have been given.");
    if (unheard == 0)
        return StopWords::tr("Every robot was told to brake; chargers, dribblers and autokick are off. %1")
            .arg(kick);
    return StopWords::tr(
               "Every robot that is heard was told to brake, with its charger, dribbler and autokick off. "
               "No longer heard, and perhaps not told: %1. Look before you reach for it. %2")
        .arg(describeRobots(unheard), kick);
}

QString told(const motionplan::Snapshot& snapshot, bool /*linkLost*/) {
    using motionplan::StopState;
    if (snapshot.outOfReach) return outOfReachText();
    switch (snapshot.stop) {
        case StopState::UnderWay:
            return StopWords::tr("Stop is being sent to the robot.");
        case StopState::Confirmed:
            return snapshot.active() ? StopWords::tr(
                                           "The robot has stopped, and executes a plan since: stop "
                                           "it again, or use its own button.")
                                     : StopWords::tr("The robot stands, as it says itself.");
        case StopState::Unconfirmed:
            return StopWords::tr(
                       "Stop was sent %1 times and not confirmed: the robot may go on. Use its own button.")
                .arg(motionplan::Exchange::kStopAttempts);
        case StopState::None:
            break;
    }
    return StopWords::tr("Stop is sent as soon as the robot is connected.");
}

QString told(const coach::Snapshot& /*snapshot*/, bool linkLost) {
    if (linkLost)
        return StopWords::tr(
            "The boat may not have been told: its own timer stops it a second after the last "
            "velocity that it heard.");
    return StopWords::tr("Zero velocity is sent in the next slot, and held until you re-arm.");
}

/// Why nobody can say that the board has heard of STOP; empty where it was told.
QString doubtOf(const smartdevice::DeviceState& board) {
    if (board.presence == smartdevice::Presence::Lost) return StopWords::tr("lost");
    // Being told disables it, and nothing is written to it before the re-arming.
    if (!board.disabled) return StopWords::tr("its port takes nothing");
    return board.presence == smartdevice::Presence::Quiet ? StopWords::tr("it is silent") : QString();
}

/// The boards that may not have heard of STOP, and the ports at whose ends there may be such.
QStringList outOfReach(const smartdevice::Snapshot& snapshot) {
    QStringList doubts;
    for (const smartdevice::DeviceState& board : snapshot.devices) {
        if (const QString doubt = doubtOf(board); !doubt.isEmpty())
            doubts << StopWords::tr("%1 at %2 (%3)")
                          .arg(QString::fromStdString(board.spec->name), QString::fromStdString(board.port),
                               doubt);
    }
    for (const smartdevice::PortState& port : snapshot.ports) {
        if (port.error && port.error->code == Errc::ClaimedElsewhere)
            doubts << StopWords::tr("what is at %1 (another program holds the port)")
                          .arg(QString::fromStdString(port.name));
    }
    return doubts;
}

QString told(const smartdevice::Snapshot& snapshot, bool linkLost) {
    if (linkLost)
        return StopWords::tr(
            "Boards may not have been told. A PolarBear disables itself when its heartbeats "
            "stop; of others nobody knows.");
    const QStringList doubts = outOfReach(snapshot);
    const bool anyTold = std::ranges::any_of(
        snapshot.devices, [](const smartdevice::DeviceState& board) { return doubtOf(board).isEmpty(); });
    if (doubts.isEmpty() && anyTold)
        return StopWords::tr(
            "Zero was written to every duty cycle and speed, and every board was disabled. Positions "
            "were left alone.");
    if (doubts.isEmpty()) return StopWords::tr("There is no board that could be told.");
    QString warning = StopWords::tr("These may not have been told: %1. Look before you reach for them.")
                          .arg(doubts.join(QStringLiteral(", ")));
    if (!anyTold) return warning;
    return StopWords::tr(
               "%1 To the duty cycles and speeds of all others zero was written, and they were "
               "disabled; positions were left alone.")
        .arg(warning);
}

}  // namespace

QString stoppedText(const SystemSnapshot& system, StopReason reason) {
    return std::visit([lost = reason == StopReason::LinkLost](const auto& own) { return told(own, lost); },
                      system);
}

}  // namespace kickstand
