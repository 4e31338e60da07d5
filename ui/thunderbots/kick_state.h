#pragma once

#include <QString>

#include "ui/thunderbots/choice_summary.h"
#include "ui/thunderbots/kick_settings.h"

namespace kickstand::ui {

// What of kicking is possible, and why not. Pure functions of what is known.

/// Why nothing of high voltage can be asked of the chosen robots; empty where it can. `snapshot` may be null.
QString reasonNotToUse(const thunderbots::Snapshot* snapshot, const ChoiceSummary& summary, bool stopped);
/// Why the pulses cannot be put on the wire; empty where they can.
QString reasonImpossible(const thunderbots::wire::KickPulses& pulses);
/// Why a kick this way cannot be given now; empty where it can.
QString reasonNotToKick(const thunderbots::Snapshot* snapshot, const ChoiceSummary& summary, bool stopped,
                        const thunderbots::wire::KickPulses& pulses, KickWay way);
/// Why autokick cannot be armed now; empty where it can.
QString reasonNotToAutokick(const thunderbots::Snapshot* snapshot, const ChoiceSummary& summary, bool stopped,
                            const thunderbots::wire::KickPulses& pulses);
/// Why a sweep cannot be started now; empty where it can.
QString reasonNotToSweep(const thunderbots::Snapshot* snapshot, const ChoiceSummary& summary, bool stopped);
/// The only robot that is chosen and heard, or -1.
int onlyRobot(const ChoiceSummary& summary);
/// How many of the robots that are heard kick by themselves.
All autokicking(const thunderbots::Snapshot& snapshot, thunderbots::RobotMask live);

}  // namespace kickstand::ui
