#include "app/kickstand-sim/coach_simulation.h"

#include <QJsonArray>

#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

QJsonValue optional(const auto& value) {
    return value ? QJsonValue(int{*value}) : QJsonValue(QJsonValue::Null);
}

}  // namespace

QString CoachSimulation::description() const {
    QStringList teams;
    for (const int team : units())
        teams << QString::number(team);
    return teams.isEmpty() ? Words::tr("an XBee adapter and no TOWRP")
                           : Words::tr("an XBee adapter and TOWRPs %1").arg(teams.join(QStringLiteral(", ")));
}

std::vector<ValueWord> CoachSimulation::shortcuts() const {
    return {{"dead", "kill", 1}, {"dead", "revive", 0}, {"plugged", "unplug", 0}, {"plugged", "plug", 1}};
}

QJsonObject CoachSimulation::show() {
    QJsonArray modules;
    for (std::size_t i = 0; i < sim_.modules(); ++i) {
        const coach::sim::XbeeSim& module = sim_.module(i);
        modules.append(
            QJsonObject{{QStringLiteral("attached"), module.attached()},
                        {QStringLiteral("address"), module.settings().address},
                        {QStringLiteral("api_mode"), module.settings().mode},
                        {QStringLiteral("packets_sent"), static_cast<qint64>(module.packetsSent())}});
    }
    QJsonArray rivals;
    for (const auto& rival : sim_.rivals()) {
        rivals.append(QJsonObject{{QStringLiteral("team"), rival->team()},
                                  {QStringLiteral("boat"), optional(rival->boat())}});
    }
    return {{QStringLiteral("modules"), modules},
            {QStringLiteral("coaches"), rivals},
            {QStringLiteral("loss"), sim_.medium().loss()}};
}

QJsonObject CoachSimulation::showUnit(int unit) const {
    const coach::sim::TowrpSim& boat = *sim_.boat(unit);
    return {{QStringLiteral("team"), unit},
            {QStringLiteral("on"), boat.isOn()},
            {QStringLiteral("coach"), optional(boat.coach())},
            {QStringLiteral("forward"), boat.velocity().forward},
            {QStringLiteral("turn"), boat.velocity().turn},
            {QStringLiteral("morale"), boat.morale()},
            {QStringLiteral("mutiny"), boat.mutinies()},
            {QStringLiteral("loss"), boat.loss()},
            {QStringLiteral("velocities"), static_cast<qint64>(boat.velocities())},
            {QStringLiteral("free_digital"), static_cast<qint64>(boat.freeDigital())},
            {QStringLiteral("free_analog_percent"), optional(boat.freeAnalog())}};
}

}  // namespace kickstand::sim
