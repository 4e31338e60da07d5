#include "core/engine/describe_stop.h"

#include <QCoreApplication>

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

QString told(const motionplan::Snapshot& snapshot, bool linkLost) {
    if (linkLost || snapshot.outOfReach)
        return StopWords::tr(
            "The robot may not have been told: it goes on with its plan. Use its own button.");
    return StopWords::tr("The robot was told to stop its plan.");
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
