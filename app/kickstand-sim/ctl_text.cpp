#include "app/kickstand-sim/ctl_text.h"

#include <QJsonArray>

#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

QString numberText(const QJsonValue& value) {
    return QString::number(value.toDouble());
}

QString valueText(const QJsonObject& action) {
    if (action.contains(QStringLiteral("value")))
        return Words::tr("the same as %1 %2")
            .arg(action[QStringLiteral("action")].toString(), numberText(action[QStringLiteral("value")]));
    QString text =
        Words::tr("%1 to %2: %3")
            .arg(numberText(action[QStringLiteral("lowest")]), numberText(action[QStringLiteral("highest")]),
                 action[QStringLiteral("unit")].toString());
    const QStringList words = action[QStringLiteral("words")].toObject().keys();
    if (!words.isEmpty()) text += Words::tr("; or %1").arg(words.join(QStringLiteral(", ")));
    return text;
}

}  // namespace

void printActions(ctl::Output& output, const QJsonObject& answer) {
    QList<QStringList> rows{{Words::tr("action"), Words::tr("of"), Words::tr("value")}};
    for (const auto& each : answer[QStringLiteral("actions")].toArray()) {
        const QJsonObject action = each.toObject();
        rows.append({action[QStringLiteral("name")].toString(),
                     action[QStringLiteral("of")].toString(QStringLiteral("-")).toUpper(),
                     valueText(action)});
    }
    output.table(rows);
}

void printDone(ctl::Output& output, const QJsonObject& answer, const QString& unitName) {
    const QJsonValue unit = answer[unitName];
    QString about;
    if (unit.isDouble()) about = Words::tr("%1 %2: ").arg(unitName, numberText(unit));
    if (unit.isString()) about = Words::tr("every %1: ").arg(unitName);
    output.line(about + answer[QStringLiteral("action")].toString() + QLatin1Char(' ') +
                numberText(answer[QStringLiteral("value")]));
}

}  // namespace kickstand::sim
