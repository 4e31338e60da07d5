#include "ui/thunderbots/words.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/thunderbots/wire/readings.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

using namespace thunderbots;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Words)
};

}  // namespace

QString ageText(Duration age) {
    const auto age_s = static_cast<qint64>(seconds(age));
    if (age_s < 120) return Words::tr("%1 s").arg(std::max<qint64>(age_s, 0));
    if (age_s < 7200) return Words::tr("%1 min").arg(age_s / 60);
    return Words::tr("%1 h").arg(age_s / 3600);
}

QString batteryText(double volts) {
    return Words::tr("%1 V").arg(volts, 0, 'f', 1);
}

QString capacitorText(double volts) {
    return Words::tr("%1 V").arg(volts, 0, 'f', 0);
}

QString robotsText(RobotMask robots) {
    if (robots == 0) return {};
    if (robots == kAllRobots) return Words::tr("all robots");
    QStringList parts;
    int count = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(robots, robot)) continue;
        int last = robot;
        while (last + 1 < kRobots && contains(robots, last + 1))
            ++last;
        count += last - robot + 1;
        parts << (last == robot       ? QString::number(robot)
                  : last == robot + 1 ? QStringLiteral("%1, %2").arg(robot).arg(last)
                                      : QStringLiteral("%1\u2013%2").arg(robot).arg(last));
        robot = last;
    }
    return (count == 1 ? Words::tr("robot %1") : Words::tr("robots %1"))
        .arg(parts.join(QStringLiteral(", ")));
}

QString toldText(const wire::DriveBlock& block) {
    QStringList parts;
    if (block.run) {
        QStringList wheels;
        for (const std::int16_t speed : block.wheels)
            wheels << signedNumber(speed);
        parts << Words::tr("run %1").arg(wheels.join(u' '));
    } else {
        parts << Words::tr("brake");
    }
    if (block.dribble) parts << Words::tr("dribbler");
    if (block.charge) parts << Words::tr("charge");
    if (block.autokickArmed) parts << Words::tr("autokick");
    return parts.join(QStringLiteral(" \u00b7 "));
}

bool isLive(const RobotState& robot) {
    return robot.capacitor && robot.capacitor->last_V >= wire::kCapacitorLive_V;
}

}  // namespace kickstand::ui
