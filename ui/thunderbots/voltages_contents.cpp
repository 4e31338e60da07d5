#include "ui/thunderbots/voltages_contents.h"

#include <QCoreApplication>
#include <array>
#include <utility>

#include "core/engine/describe.h"
#include "core/engine/describe_fault.h"
#include "core/thunderbots/wire/readings.h"
#include "ui/plot/curve_colours.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Voltages)
};

constexpr std::array kAllSignals{Signal::Battery_V, Signal::Capacitor_V, Signal::Dribbler_C, Signal::Light};
const QString kUnknown = QStringLiteral("\u2014");

int decimalsOf(Signal signal) {
    switch (signal) {
        case Signal::Battery_V:
            return 2;
        case Signal::Capacitor_V:
            return 1;
        default:
            return 0;
    }
}

PlotThreshold threshold(double value, Signal signal, const QString& meaning) {
    const int decimals = signal == Signal::Battery_V ? 1 : 0;
    return {value,
            Words::tr("%1 %2 \u00b7 %3").arg(value, 0, 'f', decimals).arg(signalUnit(signal), meaning)};
}

/// From the one that matters most on.
std::vector<PlotThreshold> thresholdsOf(Signal signal) {
    switch (signal) {
        case Signal::Battery_V:
            return {threshold(wire::kBatteryLockOut_V, signal, Words::tr("locks itself out")),
                    threshold(wire::kBatteryEmpty_V, signal, Words::tr("at its end")),
                    threshold(wire::kBatteryLow_V, signal, Words::tr("low"))};
        case Signal::Capacitor_V:
            return {threshold(wire::kCapacitorLive_V, signal, Words::tr("live")),
                    threshold(wire::kCapacitorCharged_V, signal, Words::tr("charged"))};
        case Signal::Dribbler_C:
            return {threshold(wire::dribbler_C(wire::kThermistorHighest_adc), signal,
                              Words::tr("dribbler switches itself off"))};
        case Signal::Light:
            return {threshold(wire::kBeamBall_adc, signal, Words::tr("ball"))};
    }
    return {};
}

ValueRange usualOf(Signal signal) {
    switch (signal) {
        case Signal::Battery_V:
            return {12.5, 17};
        case Signal::Capacitor_V:
            return {0, 250};
        case Signal::Dribbler_C:
            return {0, 100};
        case Signal::Light:
            return {0, 1023};
    }
    return {};
}

double readingOf(const Readings& readings, Signal signal) {
    switch (signal) {
        case Signal::Battery_V:
            return readings.battery_V;
        case Signal::Capacitor_V:
            return readings.capacitor_V;
        case Signal::Dribbler_C:
            return readings.dribbler_C;
        case Signal::Light:
            return readings.light_adc;
    }
    return 0;
}

/// The robot that a mark concerns, also where only the dongle's code says it.
int robotOf(const Mark& mark) {
    if (mark.kind == MarkKind::DeviceError) {
        const wire::Fault fault = wire::dongleFault(static_cast<std::uint8_t>(mark.value));
        if (fault.subject == wire::FaultSubject::Robot) return fault.index;
    }
    return mark.unit == kNoUnit ? -1 : mark.unit;
}

MarkWords wordsOf(const Mark& mark, const QString& robot) {
    switch (mark.kind) {
        case MarkKind::Kick: {
            const double width_ms = static_cast<double>(mark.value) / 1000;
            return {Words::tr("kick %1 ms").arg(width_ms, 0, 'f', 1),
                    Words::tr("%1: kick given to the dongle, its longer pulse %2 \u00b5s")
                        .arg(robot)
                        .arg(static_cast<double>(mark.value), 0, 'f', 0)};
        }
        case MarkKind::Autokick:
            return {Words::tr("autokick"), Words::tr("%1 kicked by itself").arg(robot)};
        case MarkKind::DeviceError: {
            const auto code = static_cast<std::uint8_t>(mark.value);
            const QString label = Words::tr("fault %1").arg(code);
            return {robot.isEmpty() ? label : Words::tr("robot %1: %2").arg(robotOf(mark)).arg(label),
                    Words::tr("Dongle error %1: %2").arg(code).arg(faultText(wire::dongleFault(code))),
                    MarkTone::Warning};
        }
        case MarkKind::Stop: {
            const auto reason = static_cast<StopReason>(static_cast<int>(mark.value));
            return {Words::tr("STOP"), Words::tr("STOP: %1").arg(describe(reason)), MarkTone::Danger};
        }
        case MarkKind::Rearmed:
            return {Words::tr("re-armed"), Words::tr("Re-armed after STOP")};
        case MarkKind::LinkUp:
            return {Words::tr("connected"), Words::tr("The link runs")};
        case MarkKind::LinkDown:
            return {Words::tr("link lost"), Words::tr("The link was lost or closed"), MarkTone::Danger};
        case MarkKind::UnitHeard:
            return {Words::tr("robot %1 heard").arg(mark.unit), Words::tr("%1 is heard").arg(robot)};
        case MarkKind::UnitLost:
            return {Words::tr("robot %1 lost").arg(mark.unit),
                    Words::tr("%1 is not heard any more").arg(robot), MarkTone::Danger};
    }
    return {};
}

}  // namespace

QString signalName(Signal signal) {
    switch (signal) {
        case Signal::Battery_V:
            return Words::tr("Battery");
        case Signal::Capacitor_V:
            return Words::tr("Capacitor");
        case Signal::Dribbler_C:
            return Words::tr("Dribbler");
        case Signal::Light:
            return Words::tr("Break beam");
    }
    return {};
}

QString signalUnit(Signal signal) {
    switch (signal) {
        case Signal::Dribbler_C:
            return QStringLiteral("\u00b0C");
        case Signal::Light:
            return Words::tr("ADC");
        default:
            return QStringLiteral("V");
    }
}

VoltagesContents voltagesContents(RobotMask robots, SignalMask wanted) {
    VoltagesContents contents;
    std::vector<std::uint16_t> units;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (contains(robots, robot)) units.push_back(static_cast<std::uint16_t>(robot));
    }
    const std::vector<int> colours = colourIndices(units);
    for (const Signal signal : kAllSignals) {
        if ((wanted & bitOf(signal)) == 0) continue;
        const auto area = static_cast<int>(contents.areas.size());
        const QString name = signalName(signal);
        contents.areas.push_back({Words::tr("%1, %2").arg(name, signalUnit(signal)), signalUnit(signal),
                                  decimalsOf(signal), usualOf(signal), thresholdsOf(signal)});
        for (std::size_t i = 0; i < units.size(); ++i) {
            contents.curves.push_back({{units[i], static_cast<std::uint16_t>(signal)},
                                       area,
                                       Words::tr("%1 %2").arg(units[i]).arg(name.toLower()),
                                       QString::number(units[i]),
                                       colours[i]});
        }
    }
    return contents;
}

std::optional<MarkWords> markWords(const Mark& mark, RobotMask robots) {
    const int robot = robotOf(mark);
    if (robot < 0) return wordsOf(mark, {});
    if (robot >= kRobots || !contains(robots, robot)) return std::nullopt;
    return wordsOf(mark, Words::tr("Robot %1").arg(robot));
}

QString marksText(const MarkCount& marks) {
    const int count = marks.count;
    const bool several = marks.units > 1;
    switch (marks.kind) {
        case MarkKind::Kick:
            return Words::tr("%n kicks", nullptr, count);
        case MarkKind::Autokick:
            return Words::tr("%n autokicks", nullptr, count);
        case MarkKind::DeviceError:
            return Words::tr("%n faults", nullptr, count);
        case MarkKind::Stop:
            return Words::tr("%n STOPs", nullptr, count);
        case MarkKind::Rearmed:
            return Words::tr("re-armed %n times", nullptr, count);
        case MarkKind::LinkUp:
            return Words::tr("connected %n times", nullptr, count);
        case MarkKind::LinkDown:
            return Words::tr("link lost %n times", nullptr, count);
        case MarkKind::UnitHeard:
            return several ? Words::tr("%n robots heard", nullptr, marks.units)
                           : Words::tr("robot %1 heard %n times", nullptr, count).arg(marks.unit);
        case MarkKind::UnitLost:
            return several ? Words::tr("%n robots lost", nullptr, marks.units)
                           : Words::tr("robot %1 lost %n times", nullptr, count).arg(marks.unit);
    }
    return {};
}

QString valueText(double value, Signal signal) {
    return signedNumber(value, decimalsOf(signal));
}

NowText nowText(const RobotState& robot, Signal signal) {
    if (!robot.feedback) return {kUnknown, false, false};
    NowText now;
    now.stale = robot.freshness != Freshness::Current;
    now.danger = signal == Signal::Capacitor_V && isLive(robot);
    const bool remembered = now.stale && signal == Signal::Capacitor_V && robot.capacitor;
    const double value = remembered ? robot.capacitor->last_V : readingOf(robot.readings, signal);
    now.text = valueText(value, signal) + u' ' + signalUnit(signal);
    // Never an old number that looks fresh.
    if (now.stale) now.text += u'?';
    return now;
}

}  // namespace kickstand::ui
