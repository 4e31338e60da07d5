#include "ui/thunderbots/kick_state.h"

#include <QCoreApplication>
#include <bit>

#include "core/engine/describe.h"
#include "ui/thunderbots/words.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(KickState)
};

QString reasonNotArmed(const ChoiceSummary& summary) {
    if (summary.armed == All::Every) return {};
    return Words::tr("The high voltage of %1 is not armed.").arg(robotsText(summary.live));
}

QString reasonSweeping(const Snapshot& snapshot, RobotMask live) {
    if (!snapshot.sweep || !snapshot.sweep->running()) return {};
    if (!contains(live, snapshot.sweep->plan.robot)) return {};
    return Words::tr("A sweep of robot %1 is running.").arg(snapshot.sweep->plan.robot);
}

QString reasonSeveral(const ChoiceSummary& summary) {
    if (std::popcount(summary.chosen) == 1) return {};
    return Words::tr("A kick is for one robot: choose one.");
}

/// The first of them that says something.
QString firstOf(std::initializer_list<QString> reasons) {
    for (const QString& reason : reasons) {
        if (!reason.isEmpty()) return reason;
    }
    return {};
}

}  // namespace

QString reasonNotToUse(const Snapshot* snapshot, const ChoiceSummary& summary, bool stopped) {
    if (snapshot == nullptr) return Words::tr("Not connected.");
    if (stopped) return Words::tr("Everything is stopped. Re-arm first.");
    if (snapshot->link != LinkState::Running)
        return Words::tr("The link does not run: %1.").arg(describe(snapshot->link));
    if (snapshot->eStop != wire::EStop::Run)
        return Words::tr("The emergency stop is not in run (%1). Turn it to run.")
            .arg(describe(snapshot->eStop));
    if (summary.chosen == 0) return Words::tr("Choose a robot: click its tile.");
    if (summary.live == 0) return Words::tr("%1 is not heard.").arg(robotsText(summary.chosen));
    return {};
}

QString reasonImpossible(const wire::KickPulses& pulses) {
    const auto encoded = wire::encodePulses(pulses);
    if (encoded) return {};
    return describe(wire::toError(encoded.error())).line();
}

QString reasonNotToKick(const Snapshot* snapshot, const ChoiceSummary& summary, bool stopped,
                        const wire::KickPulses& pulses, KickWay way) {
    const QString unusable = reasonNotToUse(snapshot, summary, stopped);
    if (!unusable.isEmpty()) return unusable;
    const wire::KickPulses sent = pulsesFor(way, pulses);
    QString empty;
    if (way != KickWay::Second && sent.width1_us == 0) empty = Words::tr("Width 1 is 0: no pulse.");
    if (way != KickWay::First && sent.width2_us == 0) empty = Words::tr("Width 2 is 0: no pulse.");
    return firstOf({reasonSeveral(summary), reasonNotArmed(summary), reasonSweeping(*snapshot, summary.live),
                    reasonImpossible(pulses), empty});
}

QString reasonNotToAutokick(const Snapshot* snapshot, const ChoiceSummary& summary, bool stopped,
                            const wire::KickPulses& pulses) {
    const QString unusable = reasonNotToUse(snapshot, summary, stopped);
    if (!unusable.isEmpty()) return unusable;
    QString empty;
    if (pulses.width1_us == 0 && pulses.width2_us == 0)
        empty = Words::tr("Both widths are 0: a robot takes that as disarmed.");
    return firstOf(
        {reasonNotArmed(summary), reasonSweeping(*snapshot, summary.live), reasonImpossible(pulses), empty});
}

QString reasonNotToSweep(const Snapshot* snapshot, const ChoiceSummary& summary, bool stopped) {
    const QString unusable = reasonNotToUse(snapshot, summary, stopped);
    if (!unusable.isEmpty()) return unusable;
    return firstOf({reasonSeveral(summary), reasonNotArmed(summary)});
}

int onlyRobot(const ChoiceSummary& summary) {
    if (std::popcount(summary.chosen) != 1 || summary.live == 0) return -1;
    return std::countr_zero(summary.live);
}

All autokicking(const Snapshot& snapshot, RobotMask live) {
    int armed = 0;
    int heard = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(live, robot)) continue;
        ++heard;
        if (snapshot.intents[static_cast<std::size_t>(robot)].autokick) ++armed;
    }
    if (armed == 0) return All::None;
    return armed == heard ? All::Every : All::Some;
}

}  // namespace kickstand::ui
