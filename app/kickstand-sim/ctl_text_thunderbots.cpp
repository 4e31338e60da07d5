#include <QJsonArray>

#include "app/kickstand-sim/ctl_text.h"
#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

QString numbers(const QJsonValue& array, const QString& between) {
    QStringList texts;
    for (const auto& each : array.toArray())
        texts << QString::number(each.toDouble());
    return texts.join(between);
}

QString volts(const QJsonValue& value, int digits) {
    return Words::tr("%1 V").arg(value.toDouble(), 0, 'f', digits);
}

QString pulses(const QJsonObject& kick) {
    return Words::tr("%1 / %2 µs")
        .arg(kick[QStringLiteral("width1_us")].toInt())
        .arg(kick[QStringLiteral("width2_us")].toInt());
}

/// "run 40 40 -40 -40, dribble"; what a robot was told last, and whether that still holds.
QString driveText(const QJsonValue& value) {
    if (!value.isObject()) return Words::tr("never told");
    const QJsonObject drive = value.toObject();
    QStringList parts;
    parts << (drive[QStringLiteral("run")].toBool()
                  ? Words::tr("run %1").arg(numbers(drive[QStringLiteral("wheels")], QStringLiteral(" ")))
                  : Words::tr("brake"));
    if (drive[QStringLiteral("charge")].toBool()) parts << Words::tr("charge");
    if (drive[QStringLiteral("dribble")].toBool()) parts << Words::tr("dribble");
    if (drive[QStringLiteral("armed")].toBool()) parts << Words::tr("autokick");
    if (!drive[QStringLiteral("fresh")].toBool()) parts << Words::tr("timed out");
    return parts.join(QStringLiteral(", "));
}

QString testModeText(const QJsonObject& robot) {
    const QJsonObject mode = robot[QStringLiteral("test_mode")].toObject();
    const int target = mode[QStringLiteral("target")].toInt();
    const QString name = mode[QStringLiteral("class")].toString();
    return target == 0 ? name : QStringLiteral("%1 %2").arg(name).arg(target);
}

QString lastKickText(const QJsonObject& kicks) {
    const QJsonArray last = kicks[QStringLiteral("last")].toArray();
    return last.isEmpty() ? QStringLiteral("-") : pulses(last.last().toObject());
}

QString countText(const QJsonValue& value) {
    return QString::number(value.toInteger());
}

void printDevice(ctl::Output& output, const QJsonObject& answer) {
    const QJsonObject device = answer[QStringLiteral("device")].toObject();
    const QJsonObject carrier = answer[QStringLiteral("carrier")].toObject();
    const bool cable = device[QStringLiteral("kind")].toString() == QLatin1String("cable");
    QString state =
        device[QStringLiteral("attached")].toBool() ? Words::tr("plugged in") : Words::tr("unplugged");
    if (carrier[QStringLiteral("in_use")].toBool()) state += Words::tr(", in use");
    QList<QStringList> rows{{cable ? Words::tr("cabled robot") : Words::tr("dongle"),
                             carrier[QStringLiteral("link")].toString(), state}};
    if (!cable) {
        rows.append({Words::tr("e-stop"), device[QStringLiteral("emergency_stop")].toString(), {}});
        rows.append({Words::tr("radios"), device[QStringLiteral("radios")].toString(),
                     Words::tr("loss %1").arg(device[QStringLiteral("loss")].toDouble())});
        const QString alive = numbers(device[QStringLiteral("alive")], QStringLiteral(", "));
        rows.append({Words::tr("robots heard"), alive.isEmpty() ? Words::tr("none") : alive, {}});
    }
    output.table(rows);
}

QStringList row(const QJsonObject& robot) {
    const QJsonObject kicks = robot[QStringLiteral("kicks")].toObject();
    return {countText(robot[QStringLiteral("robot")]),
            robot[QStringLiteral("power")].toString(),
            volts(robot[QStringLiteral("battery_V")], 1),
            volts(robot[QStringLiteral("capacitor_V")], 0),
            countText(robot[QStringLiteral("drive_blocks")]),
            countText(kicks[QStringLiteral("count")]),
            lastKickText(kicks),
            testModeText(robot),
            driveText(robot[QStringLiteral("drive")])};
}

void printParameters(ctl::Output& output, const QJsonObject& robot) {
    const QJsonObject parameters = robot[QStringLiteral("parameters")].toObject();
    QList<QStringList> rows{{Words::tr("parameters"), Words::tr("number"), Words::tr("channels"),
                             Words::tr("dribbler duty"), Words::tr("flash holds")}};
    for (const auto& [key, title] : {std::pair{QStringLiteral("shadow"), Words::tr("now")},
                                     std::pair{QStringLiteral("committed"), Words::tr("after a reboot")}}) {
        const QJsonObject block = parameters[key].toObject();
        rows.append({title, countText(block[QStringLiteral("robot_number")]),
                     numbers(block[QStringLiteral("channels")], QStringLiteral(", ")),
                     countText(block[QStringLiteral("dribbler_duty")]),
                     block[QStringLiteral("flash_contents")].toString()});
    }
    output.table(rows);
}

void printKicks(ctl::Output& output, const QJsonObject& robot) {
    const QJsonArray last = robot[QStringLiteral("kicks")][QStringLiteral("last")].toArray();
    if (last.isEmpty()) return;
    QList<QStringList> rows{{Words::tr("<kick"),
                             Words::tr("<time"),
                             Words::tr("<pulses"),
                             Words::tr("<start"),
                             Words::tr("<capacitor"),
                             {}}};
    for (const auto& each : last) {
        const QJsonObject kick = each.toObject();
        rows.append({countText(kick[QStringLiteral("number")]),
                     Words::tr("%1 s").arg(kick[QStringLiteral("time_s")].toDouble(), 0, 'f', 3),
                     pulses(kick),
                     Words::tr("%1 / %2 µs")
                         .arg(kick[QStringLiteral("start1_us")].toInt())
                         .arg(kick[QStringLiteral("start2_us")].toInt()),
                     Words::tr("%1 → %2").arg(volts(kick[QStringLiteral("before_V")], 0),
                                              volts(kick[QStringLiteral("after_V")], 0)),
                     kick[QStringLiteral("automatic")].toBool() ? Words::tr("autokick") : QString()});
    }
    output.table(rows);
}

void printRobot(ctl::Output& output, const QJsonObject& robot) {
    output.table({
        {Words::tr("robot"), countText(robot[QStringLiteral("robot")]),
         robot[QStringLiteral("power")].toString()},
        {Words::tr("battery"), volts(robot[QStringLiteral("battery_V")], 1), {}},
        {Words::tr("capacitor"), volts(robot[QStringLiteral("capacitor_V")], 0),
         robot[QStringLiteral("charging")].toBool() ? Words::tr("charging") : QString()},
        {Words::tr("dribbler"),
         Words::tr("%1 °C").arg(robot[QStringLiteral("dribbler_C")].toDouble(), 0, 'f', 0),
         robot[QStringLiteral("dribbling")].toBool() ? Words::tr("running") : QString()},
        {Words::tr("beam"),
         robot[QStringLiteral("ball")].toBool() ? Words::tr("ball") : Words::tr("free"),
         {}},
        {Words::tr("told last"), driveText(robot[QStringLiteral("drive")]), {}},
        {Words::tr("blocks"), countText(robot[QStringLiteral("drive_blocks")]),
         Words::tr("%1 changes, %2 time-outs")
             .arg(countText(robot[QStringLiteral("drive_changes")]),
                  countText(robot[QStringLiteral("drive_timeouts")]))},
        {Words::tr("wheels turn"), numbers(robot[QStringLiteral("wheel_speeds")], QStringLiteral(" ")), {}},
        {Words::tr("test mode"), testModeText(robot), {}},
    });
    output.line({});
    printParameters(output, robot);
    output.line({});
    printKicks(output, robot);
}

}  // namespace

void printThunderbots(ctl::Output& output, const QJsonObject& answer, bool oneRobot) {
    printDevice(output, answer);
    output.line({});
    const QJsonArray robots = answer[QStringLiteral("robots")].toArray();
    if (oneRobot && !robots.isEmpty()) return printRobot(output, robots.first().toObject());
    QList<QStringList> rows{{Words::tr("<robot"), Words::tr("power"), Words::tr("<battery"),
                             Words::tr("<capacitor"), Words::tr("<blocks"), Words::tr("<kicks"),
                             Words::tr("<last kick"), Words::tr("test mode"), Words::tr("told last")}};
    for (const auto& robot : robots)
        rows.append(row(robot.toObject()));
    output.table(rows);
}

}  // namespace kickstand::sim
