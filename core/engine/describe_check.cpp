#include "core/engine/describe_check.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <bit>
#include <map>
#include <string_view>

#include "core/engine/describe.h"
#include "core/engine/describe_findings.h"

namespace kickstand {

using namespace thunderbots;
using wire::TestClass;

namespace {

struct CheckWords {
    Q_DECLARE_TR_FUNCTIONS(Check)
};

/// "wheel 2, back left", "the dribbler's motor".
QString wheelText(int wheel) {
    switch (wheel) {
        case 1:
            return CheckWords::tr("wheel 1, front left");
        case 2:
            return CheckWords::tr("wheel 2, back left");
        case 3:
            return CheckWords::tr("wheel 3, back right");
        case 4:
            return CheckWords::tr("wheel 4, front right");
        default:
            return CheckWords::tr("the dribbler's motor");
    }
}

QString upperFirst(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

QString lightsText(const wire::TestMode& mode) {
    switch (mode.testClass) {
        case TestClass::Lamp:
            return CheckWords::tr("LEDs: all four on");
        case TestClass::Hall:
            return CheckWords::tr("LEDs: Hall sensors of %1").arg(wheelText(mode.target));
        case TestClass::Encoder:
            return CheckWords::tr("LEDs: encoder lines of %1").arg(wheelText(mode.target));
        case TestClass::EncoderCount:
            return CheckWords::tr("LEDs: encoder count of %1").arg(wheelText(mode.target));
        default:
            return CheckWords::tr("LEDs: charger");
    }
}

QString lightsQuestion(const wire::TestMode& mode) {
    switch (mode.testClass) {
        case TestClass::Lamp:
            return CheckWords::tr("Are all four LEDs lit?");
        case TestClass::Hall:
            return CheckWords::tr(
                       "Turn %1 by hand: do LEDs 0 to 2 change, and is never all or none of them lit?")
                .arg(wheelText(mode.target));
        case TestClass::Encoder:
            return CheckWords::tr("Turn %1 by hand: do LEDs 0 and 1 change by turns?")
                .arg(wheelText(mode.target));
        case TestClass::EncoderCount:
            return CheckWords::tr("Turn %1 by hand: do the four LEDs count?").arg(wheelText(mode.target));
        default:
            return CheckWords::tr(
                "Did LED 0 blink while the capacitor was charged, and did LED 1 stay dark?");
    }
}

QString wheelQuestion(const CheckStep& step) {
    const QString way = step.forward ? CheckWords::tr("counter-clockwise") : CheckWords::tr("clockwise");
    return CheckWords::tr(
               "Did %1, turn smoothly the way that takes the robot %2, and did the four LEDs count?")
        .arg(wheelText(step.wheel), way);
}

struct KindText {
    const char* unit;
    int decimals;
    bool least;  ///< The limit is the least that passes.
};

KindText kindText(CheckKind kind) {
    switch (kind) {
        case CheckKind::Battery:
            return {"V", 2, true};
        case CheckKind::Load:
            return {"V", 2, false};
        case CheckKind::Dribbler:
            return {"°C", 0, false};
        case CheckKind::Charge:
            return {"s", 1, false};
        case CheckKind::Kick:
            return {"V", 1, true};
        default:
            return {"V", 0, false};
    }
}

QString number(double value, CheckKind kind) {
    const KindText text = kindText(kind);
    return QStringLiteral("%1 %2").arg(value, 0, 'f', text.decimals).arg(QString::fromUtf8(text.unit));
}

std::ptrdiff_t stepsOf(const CheckProgress& progress, int robot) {
    return std::ranges::count_if(progress.rows,
                                 [robot](const CheckRow& row) { return row.step.robot == robot; });
}

/// The steps of a robot that did not pass, as "Charge (failed)".
QStringList troubles(const CheckProgress& progress, int robot) {
    QStringList all;
    for (const CheckRow& row : progress.rows) {
        if (row.step.robot != robot || row.verdict == CheckVerdict::Passed ||
            row.verdict == CheckVerdict::Waiting)
            continue;
        all << QStringLiteral("%1 (%2)").arg(describe(row.step), describe(row.verdict));
    }
    constexpr qsizetype kMost = 4;
    if (all.size() > kMost) {
        const qsizetype more = all.size() - kMost;
        all = all.first(kMost);
        all << CheckWords::tr("and %1 more").arg(more);
    }
    return all;
}

}  // namespace

QString describe(const CheckStep& step) {
    switch (step.kind) {
        case CheckKind::Ready:
            return CheckWords::tr("Robot stands free");
        case CheckKind::Battery:
            return CheckWords::tr("Battery at rest");
        case CheckKind::Wheel:
            return QStringLiteral("%1, %2").arg(upperFirst(wheelText(step.wheel)),
                                                step.forward ? QStringLiteral("+") : QString(QChar(0x2212)));
        case CheckKind::Dribbler:
            return CheckWords::tr("Dribbler, temperature after running");
        case CheckKind::Load:
            return CheckWords::tr("Battery under load, sag");
        case CheckKind::Charge:
            return CheckWords::tr("Capacitor, time to charged");
        case CheckKind::Kick:
            return CheckWords::tr("Kick, drop of the capacitor");
        case CheckKind::Discharge:
            return CheckWords::tr("Capacitor after discharge");
        case CheckKind::Lights:
            return lightsText(step.mode);
    }
    return {};
}

QString describe(CheckVerdict verdict) {
    switch (verdict) {
        case CheckVerdict::Waiting:
            return CheckWords::tr("not done");
        case CheckVerdict::Passed:
            return CheckWords::tr("passed");
        case CheckVerdict::Failed:
            return CheckWords::tr("failed");
        case CheckVerdict::Skipped:
            return CheckWords::tr("skipped");
        case CheckVerdict::NotSeen:
            return CheckWords::tr("not seen");
    }
    return {};
}

QString questionText(const CheckStep& step) {
    switch (step.kind) {
        case CheckKind::Ready:
            return CheckWords::
                tr("Does robot %1 stand on its stand, its wheels free, no hand near, no ball at its kicker?")
                    .arg(step.robot);
        case CheckKind::Wheel:
            return wheelQuestion(step);
        case CheckKind::Dribbler:
            return CheckWords::tr("Did the dribbler turn?");
        case CheckKind::Lights:
            return lightsQuestion(step.mode);
        default:
            return {};
    }
}

QString workText(const CheckRow& row, CheckStage stage) {
    if (stage == CheckStage::Discharging) return CheckWords::tr("The capacitor is emptied first…");
    switch (row.step.kind) {
        case CheckKind::Wheel:
            return CheckWords::tr("%1 runs…").arg(upperFirst(wheelText(row.step.wheel)));
        case CheckKind::Dribbler:
            return CheckWords::tr("The dribbler runs…");
        case CheckKind::Load:
            return CheckWords::tr("Everything runs, to load the battery…");
        case CheckKind::Charge:
            return CheckWords::tr("The capacitor charges: look at LED 0 and LED 1…");
        case CheckKind::Kick:
            return CheckWords::tr("Kicks, and measures the capacitor…");
        case CheckKind::Discharge:
            return CheckWords::tr("The capacitor is emptied…");
        default:
            return CheckWords::tr("%1…").arg(describe(row.step));
    }
}

QString valueText(const CheckRow& row) {
    return row.value ? number(*row.value, row.step.kind) : QString();
}

QString limitText(const CheckRow& row) {
    if (!row.limit) return {};
    const QString limit = number(*row.limit, row.step.kind);
    return (kindText(row.step.kind).least ? QStringLiteral("\u2265 %1") : QStringLiteral("\u2264 %1"))
        .arg(limit);
}

QString reasonText(const CheckRow& row) {
    if (!row.why) return {};
    Error error;
    error.code = *row.why;
    return describe(error).what;
}

QString labelOf(const CheckLimitInfo& info) {
    static const std::map<std::string_view, const char*> kLabels = {
        {"least_battery_V", QT_TRANSLATE_NOOP("Check", "Battery, at least")},
        {"most_sag_V", QT_TRANSLATE_NOOP("Check", "Sag under load, at most")},
        {"most_dribbler_C", QT_TRANSLATE_NOOP("Check", "Dribbler, at most")},
        {"most_charge_s", QT_TRANSLATE_NOOP("Check", "Charge time, at most")},
        {"least_drop_V", QT_TRANSLATE_NOOP("Check", "Drop by a kick, at least")},
        {"wheel_speed", QT_TRANSLATE_NOOP("Check", "Wheel speed")},
        {"run_s", QT_TRANSLATE_NOOP("Check", "Wheels run for")},
        {"kick_us", QT_TRANSLATE_NOOP("Check", "Kick's pulse")},
    };
    const auto found = kLabels.find(info.name);
    return found == kLabels.end() ? QString::fromLatin1(info.name) : CheckWords::tr(found->second);
}

namespace {

/// What came of a robot's steps, as far as it had any.
QString outcomeOf(const CheckProgress& progress, int robot) {
    const QString why = troubles(progress, robot).join(QStringLiteral(", "));
    switch (verdictOf(progress, robot)) {
        case CheckVerdict::Passed:
            return CheckWords::tr("Robot %1 passed its %2 steps.").arg(robot).arg(stepsOf(progress, robot));
        case CheckVerdict::Waiting:
            return progress.running() ? CheckWords::tr("Robot %1 is not through yet.").arg(robot)
                                      : CheckWords::tr("The check of robot %1 was not finished.").arg(robot);
        case CheckVerdict::Skipped:
            return CheckWords::tr("Robot %1 failed nothing, but not all was checked: %2.")
                .arg(robot)
                .arg(why);
        default:
            return CheckWords::tr("Robot %1 did not pass: %2.").arg(robot).arg(why);
    }
}

/// "Passed: robots 5, 6. Not passed: robot 7."
QString outcomeOf(const CheckProgress& progress) {
    RobotMask passed = 0;
    RobotMask others = 0;
    int only = -1;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(progress.plan.robots, robot)) continue;
        only = robot;
        (verdictOf(progress, robot) == CheckVerdict::Passed ? passed : others) |= maskOf(robot);
    }
    if (std::popcount(progress.plan.robots) == 1) return outcomeOf(progress, only);
    QStringList sentences;
    if (passed != 0) sentences << CheckWords::tr("Passed: %1.").arg(describeRobots(passed));
    if (others != 0) sentences << CheckWords::tr("Not passed: %1.").arg(describeRobots(others));
    return sentences.join(u' ');
}

/// The parts that were not chosen: who reads that a robot passed must not take them for checked.
QString withLeftOut(const QString& outcome, const CheckPlan& plan) {
    QStringList parts;
    if (!plan.wheels) parts << CheckWords::tr("wheels");
    if (!plan.dribbler) parts << CheckWords::tr("dribbler");
    if (!plan.highVoltage) parts << CheckWords::tr("charge and kick");
    if (!plan.lights) parts << CheckWords::tr("test LEDs");
    if (parts.isEmpty()) return outcome;
    return CheckWords::tr("%1 Not checked: %2.").arg(outcome, parts.join(QStringLiteral(", ")));
}

}  // namespace

QString sentenceOf(const CheckProgress& progress, int robot) {
    return withLeftOut(outcomeOf(progress, robot), progress.plan);
}

QString sentenceOf(const CheckProgress& progress) {
    if (progress.rows.empty()) return {};
    QString outcome = outcomeOf(progress);
    if (progress.endedBy) {
        Error error;
        error.code = *progress.endedBy;
        outcome = CheckWords::tr("The check was ended early: %1 %2").arg(describe(error).what, outcome);
    }
    return withLeftOut(outcome, progress.plan);
}

}  // namespace kickstand
