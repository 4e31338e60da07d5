#include "app/kickstand-sim/ctl_words.h"

#include <QJsonArray>

#include "app/kickstand-sim/words.h"
#include "app/kickstandctl/values.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

constexpr int kHighestUnit = 0xFFFF;

/// A number where the word is one (0x85 too), else the word itself.
QJsonValue valueFrom(const std::string& word) {
    const QString text = QString::fromStdString(word);
    bool isNumber = false;
    if (text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive)) {
        const uint number = text.mid(2).toUInt(&isNumber, 16);
        return isNumber ? QJsonValue(static_cast<qint64>(number)) : QJsonValue(text);
    }
    const double number = text.toDouble(&isNumber);
    return isNumber && qIsFinite(number) ? QJsonValue(number) : QJsonValue(text);
}

QString usageOf(const QJsonObject& action) {
    QString line = action[QStringLiteral("name")].toString();
    if (const QString of = action[QStringLiteral("of")].toString(); !of.isEmpty())
        line += QLatin1Char(' ') + of.toUpper();
    if (!action.contains(QStringLiteral("value"))) line += QStringLiteral(" VALUE");
    return line;
}

}  // namespace

ctl::Expected<QJsonValue> readUnit(const std::string& word, const QString& unitName, bool allowAll) {
    if (allowAll && word == "all") return QJsonValue(QStringLiteral("all"));
    const auto number = ctl::parseWhole(word, unitName.toStdString(), 0, kHighestUnit);
    if (!number) return tl::unexpected(number.error());
    return QJsonValue(*number);
}

ctl::Expected<QJsonObject> actionRequest(std::span<const std::string> words, const QJsonObject& actions) {
    const QString name = QString::fromStdString(words.front());
    QStringList names{QStringLiteral("actions"), QStringLiteral("show"), QStringLiteral("flash")};
    for (const auto& each : actions[QStringLiteral("actions")].toArray()) {
        const QJsonObject action = each.toObject();
        names << action[QStringLiteral("name")].toString();
        if (names.back() != name) continue;
        const QString of = action[QStringLiteral("of")].toString();
        const bool takesValue = !action.contains(QStringLiteral("value"));
        const std::size_t expected = 1U + (of.isEmpty() ? 0U : 1U) + (takesValue ? 1U : 0U);
        if (words.size() != expected)
            return ctl::badUsage(Words::tr("“%1” has another form.").arg(name),
                                 Words::tr("It is: kickstand-sim ctl %1.").arg(usageOf(action)));
        QJsonObject request{{QStringLiteral("request"), QStringLiteral("perform")},
                            {QStringLiteral("action"), name}};
        if (!of.isEmpty()) {
            const auto unit = readUnit(words[1], of, true);
            if (!unit) return tl::unexpected(unit.error());
            request[of] = *unit;
        }
        if (takesValue) request[QStringLiteral("value")] = valueFrom(words.back());
        return request;
    }
    return ctl::badUsage(Words::tr("There is no “%1” here.").arg(printable(words.front())),
                         Words::tr("There is: %1.").arg(names.join(QStringLiteral(", "))));
}

}  // namespace kickstand::sim
