#include "core/engine/describe_stop.h"

#include <QCoreApplication>

#include "core/engine/describe_motionplan.h"
#include "core/motionplan/exchange.h"

namespace kickstand {
namespace {

struct StopWords {
    Q_DECLARE_TR_FUNCTIONS(StopWords)
};

QString told(const thunderbots::Snapshot& /*snapshot*/, bool linkLost) {
    if (linkLost)
        return StopWords::tr(
            "Robots may not have been told: they brake by themselves within 2.2 s. Look before "
            "you reach for them.");
    return StopWords::tr(
        "Every robot was told to brake; chargers, dribblers and autokick are off. A kick that "
        "the dongle already held may still have been given.");
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

QString told(const smartdevice::Snapshot& /*snapshot*/, bool linkLost) {
    if (linkLost)
        return StopWords::tr(
            "Boards may not have been told. A PolarBear disables itself when its heartbeats "
            "stop; of others nobody knows.");
    return StopWords::tr(
        "Zero was written to every duty cycle and speed, and every board was disabled. Positions "
        "were left alone.");
}

}  // namespace

QString stoppedText(const SystemSnapshot& system, StopReason reason) {
    return std::visit([lost = reason == StopReason::LinkLost](const auto& own) { return told(own, lost); },
                      system);
}

}  // namespace kickstand
