#include "app/kickstand-sim/board_simulation.h"

#include <QJsonArray>

#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

using smartdevice::sim::BoardReport;
using smartdevice::sim::BoardSim;

qint64 toNumber(std::uint64_t count) {
    return static_cast<qint64>(count);
}

QJsonArray valuesOf(BoardSim& board) {
    QJsonArray values;
    for (std::size_t i = 0; i < board.body().parameters().size(); ++i) {
        const auto number = smartdevice::wire::toNumber(board.value(static_cast<int>(i)));
        values.append(number ? QJsonValue(*number) : QJsonValue());
    }
    return values;
}

}  // namespace

QString BoardSimulation::description() const {
    QStringList kinds;
    for (int i = 0; i < sim_.count(); ++i)
        kinds << QString::fromStdString(sim_.kind(i));
    return Words::tr("smart devices, simulated: %1").arg(kinds.join(QStringLiteral(", ")));
}

QJsonObject BoardSimulation::show() {
    QJsonArray kinds;
    for (int i = 0; i < sim_.count(); ++i)
        kinds.append(QString::fromStdString(sim_.kind(i)));
    return {{QStringLiteral("kinds"), kinds}};
}

QJsonObject BoardSimulation::showUnit(int unit) const {
    BoardSim& board = sim_.board(unit);
    const BoardReport report = board.report();
    return {{QStringLiteral("device"), unit},
            {QStringLiteral("kind"), QString::fromStdString(sim_.kind(unit))},
            {QStringLiteral("uid"), QString::fromStdString(smartdevice::wire::toText(board.uid()))},
            {QStringLiteral("attached"), board.attached()},
            {QStringLiteral("line_open"), report.lineOpen},
            {QStringLiteral("disabled"), report.disabled},
            {QStringLiteral("delay_ms"), report.subscription.delay_ms},
            {QStringLiteral("messages"), toNumber(report.heard.messages)},
            {QStringLiteral("damaged"), toNumber(report.heard.faults())},
            {QStringLiteral("writes"), toNumber(report.writes)},
            {QStringLiteral("disables"), toNumber(report.disables)},
            {QStringLiteral("self_disables"), toNumber(report.selfDisables)},
            {QStringLiteral("resets"), toNumber(report.resets)},
            {QStringLiteral("values"), valuesOf(board)}};
}

}  // namespace kickstand::sim
