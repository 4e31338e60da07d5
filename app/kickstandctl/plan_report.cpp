#include "app/kickstandctl/plan_report.h"

#include <QJsonArray>
#include <array>

#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/words.h"
#include "core/base/hex.h"
#include "core/engine/describe_motionplan.h"
#include "core/motionplan/plan.h"
#include "core/motionplan/wire/nxt_status.h"
#include "core/motionplan/wire/plan_text.h"

namespace kickstand::ctl {
namespace {

using motionplan::Execution;

QString planText(const std::vector<std::uint8_t>& movements) {
    return QString::fromStdString(motionplan::wire::toText(motionplan::movementsOf(movements)));
}

QLatin1String nameOf(Execution::State state) {
    constexpr std::array<const char*, 4> kNames{"idle", "asked", "executing", "unsure"};
    return QLatin1String(kNames.at(static_cast<std::size_t>(state)));
}

template <class Kept>
QJsonObject keptToJson(const Kept& kept) {
    QJsonObject json{{QStringLiteral("known"), kept.known}};
    if (!kept.known) return json;
    json[QStringLiteral("plan")] = kept.plan == 0 ? QJsonValue(QJsonValue::Null) : QJsonValue(kept.plan);
    if (kept.movements.empty()) return json;
    json[QStringLiteral("movements")] = planText(kept.movements);
    json[QStringLiteral("bytes")] = QString::fromStdString(toHex(kept.movements));
    return json;
}

QString heldText(bool known, int plan) {
    if (!known) return Words::tr("not asked");
    if (plan == motionplan::wire::kNoPlan) return Words::tr("empty");
    return Words::tr("plan %1").arg(plan);
}

template <class Kept>
QStringList keptRow(const QString& place, const Kept& kept) {
    return {place, heldText(kept.known, kept.plan), planText(kept.movements)};
}

}  // namespace

QJsonObject robotToJson(const LinkUri& uri, const motionplan::Snapshot& state) {
    QJsonArray slotArray;
    for (std::size_t slot = 0; slot < state.slotStates.size(); ++slot) {
        QJsonObject one = keptToJson(state.slotStates[slot]);
        one[QStringLiteral("slot")] = static_cast<int>(slot);
        slotArray.append(one);
    }
    QJsonObject execution{{QStringLiteral("state"), nameOf(state.execution.state)}};
    if (state.active()) {
        execution[QStringLiteral("plan")] = state.execution.plan;
        execution[QStringLiteral("slot")] = state.execution.slot;
        execution[QStringLiteral("step")] = state.execution.step;
        execution[QStringLiteral("stale")] = state.execution.stale;
    }
    QJsonObject json{
        {QStringLiteral("link"), QString::fromStdString(toString(uri))},
        {QStringLiteral("simulated"), uri.isSimulated()},
        {QStringLiteral("nxt_status"), QLatin1String(motionplan::wire::nxtStatus(state.nxtStatus).id)},
        {QStringLiteral("slots"), slotArray},
        {QStringLiteral("trigger"), keptToJson(state.trigger)},
        {QStringLiteral("execution"), execution}};
    addClosing(json, state);
    return json;
}

void addClosing(QJsonObject& json, const motionplan::Snapshot& state) {
    const int plan = state.trigger.plan;
    if (plan != motionplan::wire::kNoPlan)
        json[QStringLiteral("starts_when_closed")] = plan;
    else if (state.trigger.known)
        json[QStringLiteral("starts_when_closed")] = QJsonValue(QJsonValue::Null);
}

QString closingText(const motionplan::Snapshot& state) {
    const int plan = state.trigger.plan;
    if (plan != motionplan::wire::kNoPlan && state.trigger.known)
        return Words::tr("Closing the connection starts its trigger plan %1: it drives off now.").arg(plan);
    if (plan != motionplan::wire::kNoPlan)
        return Words::tr("Closing the connection may start its trigger plan %1: it may drive off now.")
            .arg(plan);
    if (state.trigger.known) return {};
    return Words::tr("Whether it has a trigger plan, which closing the connection starts, is not known.");
}

void showRobot(Output& output, const LinkUri& uri, const motionplan::Snapshot& state) {
    output.value(robotToJson(uri, state));
    QList<QStringList> rows;
    for (std::size_t slot = 0; slot < state.slotStates.size(); ++slot) {
        if (state.slotStates[slot].known)
            rows.append(keptRow(Words::tr("slot %1").arg(slot), state.slotStates[slot]));
    }
    if (state.trigger.known) rows.append(keptRow(Words::tr("trigger"), state.trigger));
    QString doing = state.nxtStatus == motionplan::wire::kStatusNoProgram
                        ? Words::tr("no program is running on the NXT")
                        : describe(state.execution.state);
    if (state.active())
        doing = Words::tr("%1 plan %2 in slot %3, step %4")
                    .arg(doing)
                    .arg(state.execution.plan)
                    .arg(state.execution.slot)
                    .arg(state.execution.step);
    rows.append({Words::tr("robot"), doing, {}});
    output.table(rows);
    if (const QString closing = closingText(state); !closing.isEmpty()) output.line(closing);
}

}  // namespace kickstand::ctl
