#include "app/kickstand-sim/nxt_simulation.h"

#include <QJsonArray>

#include "app/kickstand-sim/json.h"
#include "app/kickstand-sim/words.h"
#include "core/base/hex.h"

namespace kickstand::sim {
namespace {

constexpr int kDigits = 3;

QJsonValue planToJson(const motionplan::sim::KeptPlan& plan) {
    if (plan.empty()) return QJsonValue::Null;
    return QJsonObject{{QStringLiteral("plan"), plan.id},
                       {QStringLiteral("movements"), QString::fromStdString(toHex(plan.movements))}};
}

qint64 toNumber(std::uint64_t count) {
    return static_cast<qint64>(count);
}

}  // namespace

QString NxtSimulation::description() const {
    return Words::tr("an NXT that takes motion plans, simulated");
}

std::vector<ValueWord> NxtSimulation::valueWords() const {
    return {{"text", "on", 1}, {"text", "off", 0}, {"program", "running", 1}, {"program", "ended", 0}};
}

std::vector<ValueWord> NxtSimulation::shortcuts() const {
    return {{"plugged", "unplug", 0}, {"plugged", "replug", 1}};
}

QJsonObject NxtSimulation::show() {
    const motionplan::sim::NxtReport report = sim_.report();
    const motionplan::sim::RobotProgram& program = sim_.program();
    QJsonArray kept;
    for (const motionplan::sim::KeptPlan& plan : program.kept())
        kept.append(planToJson(plan));
    QJsonValue motion = QJsonValue::Null;
    if (program.motion()) {
        const motionplan::sim::Motion& now = *program.motion();
        motion = QJsonObject{{QStringLiteral("plan"), now.plan},
                             {QStringLiteral("slot"), now.slot},
                             {QStringLiteral("trigger"), now.trigger},
                             {QStringLiteral("step"), static_cast<int>(now.step) + 1},
                             {QStringLiteral("done"), rounded(now.done, kDigits)}};
    }
    return {{QStringLiteral("plugged"), report.attached},
            {QStringLiteral("open"), report.open},
            {QStringLiteral("program"), report.programRuns},
            {QStringLiteral("slots"), kept},
            {QStringLiteral("trigger"), planToJson(program.trigger())},
            {QStringLiteral("motion"), motion},
            {QStringLiteral("executed"), toNumber(program.executed())},
            {QStringLiteral("written"), toNumber(report.written)},
            {QStringLiteral("reads"), toNumber(report.reads)},
            {QStringLiteral("lost"), toNumber(report.lost)},
            {QStringLiteral("overflows"), toNumber(report.overflows)},
            {QStringLiteral("skipped_bytes"), toNumber(report.skipped)}};
}

// There are no units, and nobody asks for one.
QJsonObject NxtSimulation::showUnit(int) const {
    return {};
}
void NxtSimulation::readFlash(int, std::uint32_t, ByteSpan) const {}

}  // namespace kickstand::sim
