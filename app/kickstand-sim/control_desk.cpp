#include "app/kickstand-sim/control_desk.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cmath>

#include "app/kickstand-sim/json.h"
#include "app/kickstand-sim/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

constexpr QLatin1String kRequest("request");
constexpr QLatin1String kAction("action");
constexpr QLatin1String kValue("value");
constexpr QLatin1String kId("id");
constexpr QLatin1String kAddress("address");
constexpr QLatin1String kLength("length");
constexpr int kEveryUnit = -1;

QString fromName(const std::string& text) {
    return QString::fromStdString(text);
}

tl::unexpected<ctl::Failure> refuse(Errc code, const QString& what, const QString& remedy) {
    return tl::unexpected<ctl::Failure>({ctl::kFailed, {what, remedy, {}}, QLatin1String(name(code))});
}

QString requestExample() {
    return Words::tr(
               "A request looks like {\"request\": \"show\", \"robot\": 3}, in one line of at most %1 "
               "bytes.")
        .arg(kMaxRequestBytes);
}

ctl::Expected<QJsonObject> readLine(ByteView line) {
    QJsonParseError error;
    const auto document =
        QJsonDocument::fromJson(QByteArray::fromRawData(reinterpret_cast<const char*>(line.data()),
                                                        static_cast<qsizetype>(line.size())),
                                &error);
    if (document.isObject()) return document.object();
    const QString why =
        error.error == QJsonParseError::NoError ? Words::tr("it is an array") : error.errorString();
    return refuse(Errc::Malformed, Words::tr("That line is not a JSON object: %1.").arg(why),
                  requestExample());
}

ctl::Outcome allowOnly(const QJsonObject& request, QStringList keys) {
    keys << kRequest << kId;
    for (const QString& key : request.keys()) {
        if (keys.contains(key)) continue;
        return refuse(Errc::UnknownName,
                      Words::tr("“%1” means nothing in this request.").arg(printable(key.toStdString())),
                      Words::tr("It takes: %1.").arg(keys.join(QStringLiteral(", "))));
    }
    return {};
}

/// A number in a request that counts bytes.
ctl::Expected<std::uint32_t> readCount(const QJsonObject& request, QLatin1String key, std::uint32_t lowest,
                                       std::uint32_t highest) {
    const double value = request[key].toDouble(-1);
    if (value >= lowest && value <= highest && value == std::floor(value))
        return static_cast<std::uint32_t>(value);
    return refuse(Errc::OutOfRange, Words::tr("“%1” cannot be that.").arg(key),
                  Words::tr("It is a whole number from %1 to %2.").arg(lowest).arg(highest));
}

const SimAction* find(const std::vector<SimAction>& actions, const QString& name) {
    const auto found =
        std::ranges::find_if(actions, [&](const SimAction& action) { return fromName(action.name) == name; });
    return found == actions.end() ? nullptr : &*found;
}

QJsonObject describeAction(const SimAction& action, const QString& unitKey) {
    return {{QStringLiteral("name"), fromName(action.name)},
            {QStringLiteral("of"), action.perUnit ? QJsonValue(unitKey) : QJsonValue()},
            {QStringLiteral("unit"), fromName(action.unit)},
            {QStringLiteral("lowest"), action.lowest},
            {QStringLiteral("highest"), action.highest}};
}

}  // namespace

QString ControlDesk::unitKey() const {
    return QLatin1String(simulation_.unitName());
}

QByteArray ControlDesk::answer(ByteView line) {
    const auto request = readLine(line);
    if (!request) return compact(toJson(request.error()));
    const Answer answer = handle(*request);
    QJsonObject json = answer ? *answer : toJson(answer.error());
    if (answer) json[QStringLiteral("ok")] = true;
    const QJsonValue id = request->value(kId);
    if (id.isDouble() || id.isString()) json[kId] = id;
    return compact(json);
}

QByteArray ControlDesk::answerToTooLong() {
    const auto refused =
        refuse(Errc::Malformed, Words::tr("That line is longer than a request can be."), requestExample());
    return compact(toJson(refused.value()));
}

ControlDesk::Answer ControlDesk::handle(const QJsonObject& request) {
    const QString what = request[kRequest].toString();
    if (what == QLatin1String("actions"))
        return allowOnly(request, {}).and_then([this] { return actions(); });
    if (what == QLatin1String("perform"))
        return allowOnly(request, {kAction, unitKey(), kValue}).and_then([&] { return perform(request); });
    if (what == QLatin1String("show"))
        return allowOnly(request, {unitKey()}).and_then([&] { return show(request); });
    if (what == QLatin1String("flash"))
        return allowOnly(request, {unitKey(), kAddress, kLength}).and_then([&] { return flash(request); });
    return refuse(Errc::UnknownName, Words::tr("There is no such request."),
                  Words::tr("“request” is one of: actions, perform, show, flash."));
}

ControlDesk::Answer ControlDesk::actions() const {
    const auto known = simulation_.control().actions();
    QJsonArray all;
    for (const SimAction& action : known) {
        QJsonObject json = describeAction(action, unitKey());
        QJsonObject words;
        for (const ValueWord& word : simulation_.valueWords()) {
            if (action.name == word.action) words[QLatin1String(word.word)] = word.value;
        }
        if (!words.isEmpty()) json[QStringLiteral("words")] = words;
        all.append(json);
    }
    for (const ValueWord& shortcut : simulation_.shortcuts()) {
        const SimAction* action = find(known, QLatin1String(shortcut.action));
        if (action == nullptr) continue;
        QJsonObject json{{QStringLiteral("name"), QLatin1String(shortcut.word)},
                         {QStringLiteral("of"), action->perUnit ? QJsonValue(unitKey()) : QJsonValue()},
                         {kAction, QLatin1String(shortcut.action)},
                         {kValue, shortcut.value}};
        all.append(json);
    }
    QJsonArray units;
    for (const int unit : simulation_.units())
        units.append(unit);
    return QJsonObject{{QStringLiteral("system"), QLatin1String(simulation_.family())},
                       {QStringLiteral("of"), unitKey()},
                       {QStringLiteral("units"), units},
                       {QStringLiteral("actions"), all}};
}

ControlDesk::Answer ControlDesk::perform(const QJsonObject& request) {
    QString wanted = request[kAction].toString();
    QJsonValue value = request[kValue];
    for (const ValueWord& shortcut : simulation_.shortcuts()) {
        if (wanted != QLatin1String(shortcut.word)) continue;
        if (!value.isUndefined())
            return refuse(Errc::BadArgument, Words::tr("“%1” takes no value.").arg(wanted),
                          Words::tr("Leave it out."));
        wanted = QLatin1String(shortcut.action);
        value = shortcut.value;
        break;
    }
    const auto known = simulation_.control().actions();
    if (const SimAction* action = find(known, wanted)) return performOn(*action, request, value);
    QStringList names;
    for (const SimAction& action : known)
        names << fromName(action.name);
    for (const ValueWord& shortcut : simulation_.shortcuts())
        names << QLatin1String(shortcut.word);
    return refuse(Errc::UnknownName,
                  Words::tr("There is no action “%1” here.").arg(printable(wanted.toStdString())),
                  Words::tr("There is: %1.").arg(names.join(QStringLiteral(", "))));
}

ControlDesk::Answer ControlDesk::performOn(const SimAction& action, const QJsonObject& request,
                                           const QJsonValue& value) {
    const QString shown = fromName(action.name);
    const QJsonValue target = request[unitKey()];
    if (!action.perUnit && !target.isUndefined())
        return refuse(Errc::BadArgument, Words::tr("“%1” is not about one %2.").arg(shown, unitKey()),
                      Words::tr("Leave the number out."));
    int unit = kEveryUnit;
    if (action.perUnit && target != QJsonValue(QStringLiteral("all"))) {
        const auto one = readUnit(target);
        if (!one) return tl::unexpected(one.error());
        unit = *one;
    }
    const auto number = readValue(action, value);
    if (!number) return tl::unexpected(number.error());
    if (const auto done = simulation_.control().perform(action.name, unit, *number); !done)
        return ctl::failed(done.error());
    QJsonObject json{{kAction, shown}, {kValue, *number}};
    if (action.perUnit) json[unitKey()] = target;
    return json;
}

ControlDesk::Answer ControlDesk::show(const QJsonObject& request) {
    QJsonObject json = simulation_.show();
    json[QStringLiteral("system")] = QLatin1String(simulation_.family());
    if (carrier_ != nullptr) json[QStringLiteral("carrier")] = carrier_->report();
    std::vector<int> wanted = simulation_.units();
    if (const QJsonValue target = request[unitKey()]; !target.isUndefined()) {
        const auto unit = readUnit(target);
        if (!unit) return tl::unexpected(unit.error());
        wanted = {*unit};
    }
    QJsonArray units;
    for (const int unit : wanted)
        units.append(simulation_.showUnit(unit));
    json[unitKey() + QLatin1Char('s')] = units;
    return json;
}

ControlDesk::Answer ControlDesk::flash(const QJsonObject& request) const {
    const std::uint32_t all = simulation_.flashBytes();
    if (all == 0)
        return refuse(Errc::Unsupported, Words::tr("There is no flash memory here."),
                      Words::tr("Ask for something else."));
    const auto unit = readUnit(request[unitKey()]);
    if (!unit) return tl::unexpected(unit.error());
    const auto address = readCount(request, kAddress, 0, all - 1);
    if (!address) return tl::unexpected(address.error());
    const auto length = readCount(request, kLength, 1, std::min(kMaxFlashPiece, all - *address));
    if (!length) return tl::unexpected(length.error());
    std::vector<std::uint8_t> piece(*length);
    simulation_.readFlash(*unit, *address, piece);
    const auto bytes = QByteArray::fromRawData(reinterpret_cast<const char*>(piece.data()),
                                               static_cast<qsizetype>(piece.size()));
    return QJsonObject{{unitKey(), *unit},
                       {kAddress, static_cast<qint64>(*address)},
                       {kLength, static_cast<qint64>(*length)},
                       {QStringLiteral("flash_bytes"), static_cast<qint64>(all)},
                       {QStringLiteral("base64"), QString::fromLatin1(bytes.toBase64())}};
}

ctl::Expected<int> ControlDesk::readUnit(const QJsonValue& value) const {
    const auto units = simulation_.units();
    QStringList numbers;
    for (const int unit : units) {
        if (value.isDouble() && value.toDouble() == unit) return unit;
        numbers << QString::number(unit);
    }
    const QString there = Words::tr("There is: %1.").arg(numbers.join(QStringLiteral(", ")));
    if (value.isDouble())
        return refuse(Errc::NoDevice,
                      Words::tr("There is no %1 %2 here.").arg(unitKey()).arg(value.toDouble()), there);
    return refuse(Errc::BadArgument, Words::tr("The number of the %1 is missing.").arg(unitKey()), there);
}

ctl::Expected<double> ControlDesk::readValue(const SimAction& action, const QJsonValue& value) const {
    if (value.isDouble()) return value.toDouble();
    QStringList words;
    for (const ValueWord& word : simulation_.valueWords()) {
        if (action.name != word.action) continue;
        if (value.toString() == QLatin1String(word.word)) return word.value;
        words << QLatin1String(word.word);
    }
    QString remedy = Words::tr("It is a number from %1 to %2 (%3)")
                         .arg(action.lowest)
                         .arg(action.highest)
                         .arg(fromName(action.unit));
    if (!words.isEmpty()) remedy += Words::tr(", or one of: %1").arg(words.join(QStringLiteral(", ")));
    const QString name = fromName(action.name);
    if (!value.isString())
        return refuse(Errc::BadArgument, Words::tr("“%1” needs a value.").arg(name),
                      remedy + QLatin1Char('.'));
    return refuse(Errc::BadArgument,
                  Words::tr("“%1” cannot be “%2”.").arg(name, printable(value.toString().toStdString())),
                  remedy + QLatin1Char('.'));
}

}  // namespace kickstand::sim
