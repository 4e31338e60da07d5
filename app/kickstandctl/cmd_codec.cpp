#include <array>
#include <limits>

#include "app/kickstandctl/arguments.h"
#include "app/kickstandctl/codecs.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/words.h"
#include "core/base/hex.h"
#include "core/engine/describe_facts.h"

namespace kickstand::ctl {
namespace {

constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// What went wrong with a message; where its name is unknown, with the one that was probably meant.
tl::unexpected<Failure> refusedMessage(const std::string& name, const Error& error) {
    auto failure = refusedInput(error);
    if (error.code != Errc::UnknownName || error.subject != name) return failure;
    std::vector<std::string> names;
    for (const Codec& codec : codecs()) {
        for (const CodecMessage& message : codec.messages())
            names.push_back(message.name);
    }
    if (const std::string near = nearest(name, names); !near.empty())
        failure.value().text.remedy = Words::tr("Did you mean “%1”?").arg(QString::fromStdString(near));
    return failure;
}

/// "_V", "_us": the end of a JSON name for a value in this unit.
QString suffix(const std::string& unit) {
    QString text = QString::fromStdString(unit);
    text.replace(QStringLiteral("µ"), QStringLiteral("u")).remove(QStringLiteral("°"));
    return QLatin1Char('_') + text;
}

QJsonObject fieldsToJson(const std::vector<CodecField>& fields, bool units) {
    QJsonObject json;
    for (const CodecField& field : fields) {
        const QString name = QString::fromStdString(field.name);
        json[name] = field.isBytes ? QJsonValue(QString::fromStdString(toHex(field.bytes)))
                                   : QJsonValue(qint64{field.value});
        if (!units) continue;
        if (field.physical) json[name + suffix(field.unit)] = *field.physical;
        if (!field.label.empty()) json[name + QStringLiteral("_name")] = QString::fromStdString(field.label);
    }
    return json;
}

QStringList fieldRow(const CodecField& field) {
    const QString value =
        field.isBytes ? QString::fromStdString(toHex(field.bytes)) : QString::number(field.value);
    QString meaning = QString::fromStdString(field.label);
    if (field.physical)
        meaning =
            QStringLiteral("%1 %2").arg(*field.physical, 0, 'g', 5).arg(QString::fromStdString(field.unit));
    return {QString::fromStdString(field.name), value, meaning, QString::fromStdString(field.description)};
}

Outcome decode(const Context& context) {
    const auto& operands = context.invocation.operands;
    std::string hex;
    for (std::size_t i = 1; i < operands.size(); ++i)
        hex += operands[i] + ' ';
    const auto bytes = parseHex(hex);
    if (!bytes) return refusedInput(bytes.error());
    const auto fields = codecFor(operands[0]).decode(operands[0], *bytes);
    if (!fields) return refusedMessage(operands[0], fields.error());

    context.output.value(fieldsToJson(*fields, context.invocation.has("--units")));
    QList<QStringList> rows;
    for (const CodecField& field : *fields)
        rows.append(fieldRow(field));
    context.output.table(rows);
    if (fields->empty()) context.output.line(Words::tr("This message has no fields."));
    return {};
}

Outcome encode(const Context& context) {
    const auto& operands = context.invocation.operands;
    std::vector<CodecText> fields;
    for (std::size_t i = 1; i < operands.size(); ++i) {
        const std::size_t equals = operands[i].find('=');
        if (equals == std::string::npos || equals == 0)
            return badUsage(Words::tr("“%1” is no field with its value.").arg(printable(operands[i])),
                            Words::tr("Write it as FIELD=VALUE, as in wheel1=40."));
        fields.emplace_back(operands[i].substr(0, equals), operands[i].substr(equals + 1));
    }
    const auto bytes = codecFor(operands[0]).encode(operands[0], fields);
    if (!bytes) return refusedMessage(operands[0], bytes.error());

    const QString hex = QString::fromStdString(toHex(*bytes));
    QJsonArray numbers;
    for (const std::uint8_t byte : *bytes)
        numbers.append(byte);
    context.output.value(QJsonObject{{QStringLiteral("message"), QString::fromStdString(operands[0])},
                                     {QStringLiteral("hex"), hex},
                                     {QStringLiteral("bytes"), numbers}});
    context.output.line(hex);
    return {};
}

/// Every message, each with its fields on the line below.
QString messageList() {
    QString text = Words::tr("Messages and their fields:") + QLatin1Char('\n');
    for (const Codec& codec : codecs()) {
        for (const CodecMessage& message : codec.messages()) {
            QStringList fields;
            for (const std::string& field : message.fields)
                fields.append(QString::fromStdString(field));
            text += QStringLiteral("  %1\n      %2\n")
                        .arg(QString::fromStdString(message.name), fields.join(QLatin1Char(' ')));
        }
    }
    return text;
}

constexpr std::array kDecodeOptions{OptionSpec{
    "--units", "",
    QT_TRANSLATE_NOOP("kickstandctl", "with --json: add volts, µs and names beside the raw numbers")}};

constexpr CommandSpec kCommands[] = {
    {"decode", "MESSAGE HEX…", 2, kAnyNumber,
     QT_TRANSLATE_NOOP("kickstandctl", "Takes a message apart into its fields. Works offline."),
     QT_TRANSLATE_NOOP("kickstandctl", "Spaces and colons between bytes may be there or not."),
     kDecodeOptions, "decode thunderbots.kick cb 80 00", decode, messageList},
    {"encode",
     "MESSAGE [FIELD=VALUE]…",
     1,
     kAnyNumber,
     QT_TRANSLATE_NOOP("kickstandctl", "Puts a message together from its fields. Works offline."),
     QT_TRANSLATE_NOOP("kickstandctl", "Fields that are left out are zero."),
     {},
     "encode thunderbots.drive run=1 wheel1=40 wheel3=-36",
     encode,
     messageList},
};

}  // namespace

std::span<const CommandSpec> codecCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
