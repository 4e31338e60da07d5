#include "app/kickstandctl/text.h"

#include <QDateTime>
#include <QStringList>

#include "app/kickstandctl/words.h"
#include "core/engine/describe.h"
#include "core/engine/describe_facts.h"
#include "core/engine/describe_findings.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::ctl {

QString batteryText(double battery_V) {
    return Words::tr("%1 V").arg(battery_V, 0, 'f', 1);
}

QString capacitorText(double capacitor_V) {
    return Words::tr("%1 V").arg(capacitor_V, 0, 'f', 0);
}

QString robotsText(thunderbots::RobotMask robots) {
    QStringList runs;
    for (int first = 0; first < thunderbots::kRobots; ++first) {
        if (!thunderbots::contains(robots, first)) continue;
        int last = first;
        while (last + 1 < thunderbots::kRobots && thunderbots::contains(robots, last + 1))
            ++last;
        runs << (last > first ? QStringLiteral("%1-%2").arg(first).arg(last) : QString::number(first));
        first = last;
    }
    return runs.join(QStringLiteral(", "));
}

QString robotsPhrase(thunderbots::RobotMask robots) {
    return describeRobots(robots);
}

QString clockText(const Engine& engine, TimePoint time) {
    const auto sinceEpoch = engine.wallTime(time).time_since_epoch();
    const auto sinceEpoch_ms = std::chrono::duration_cast<std::chrono::milliseconds>(sinceEpoch).count();
    return QDateTime::fromMSecsSinceEpoch(sinceEpoch_ms).toString(QStringLiteral("hh:mm:ss.zzz"));
}

QString eventLine(const Engine& engine, const EngineEvent& event) {
    return QStringLiteral("%1  %2  %3")
        .arg(clockText(engine, timeOf(event)), aboutOf(event).leftJustified(8), describe(event).text);
}

QString deviceText(const LinkUri& uri, const thunderbots::Snapshot& state) {
    const QString kind = state.cable ? Words::tr("cabled robot") : Words::tr("dongle");
    if (uri.isSimulated()) return Words::tr("simulated %1").arg(kind);
    return Words::tr("%1 at %2").arg(kind, printable(state.device.port));
}

QString liveCapacitorText(int number, const thunderbots::RobotState& robot) {
    if (!robot.capacitor || robot.capacitor->last_V < thunderbots::wire::kCapacitorLive_V) return {};
    return Words::tr("Robot %1 had %2 on its capacitor: treat as live.")
        .arg(number)
        .arg(capacitorText(robot.capacitor->last_V));
}

}  // namespace kickstand::ctl
