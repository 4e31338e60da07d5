#include "app/kickstandctl/parameter_options.h"

#include <QFile>

#include "app/kickstandctl/save_file.h"
#include "app/kickstandctl/words.h"
#include "core/base/hex.h"
#include "core/engine/describe_facts.h"
#include "core/engine/describe_parameter_file.h"
#include "core/engine/describe_parameters.h"

namespace kickstand::ctl {
namespace {

using thunderbots::ParameterField;
using thunderbots::ParameterValues;

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

Expected<ParameterValues> readFile(std::string_view path) {
    QFile file(fromView(path));
    if (!file.open(QIODevice::ReadOnly))
        return badUsage(
            Words::tr("“%1” cannot be read: %2.").arg(printable(std::string(path)), file.errorString()),
            Words::tr("Check the name of the file."));
    const auto values = readParameterFile(file.read(kLongestParameterFile + 1));
    if (!values) return refusedInput(values.error());
    return *values;
}

Outcome readOne(std::string_view operand, ParameterValues& values, thunderbots::ParameterMask& given) {
    const std::size_t equals = operand.find('=');
    const auto field = thunderbots::parameterFieldFromName(operand.substr(0, equals));
    if (!field || equals == std::string_view::npos) {
        QStringList names;
        for (const ParameterField one : thunderbots::kParameterFields)
            names << fromView(thunderbots::name(one));
        return badUsage(Words::tr("“%1” is no FIELD=VALUE.").arg(printable(std::string(operand))),
                        Words::tr("The fields are %1.").arg(names.join(QStringLiteral(", "))));
    }
    if (thunderbots::contains(given, *field))
        return badUsage(Words::tr("%1 was given twice.").arg(fromView(thunderbots::name(*field))),
                        Words::tr("Give it once."));
    given = static_cast<thunderbots::ParameterMask>(given | thunderbots::maskOf(*field));
    const auto value = thunderbots::parseParameter(*field, operand.substr(equals + 1));
    if (!value) return refusedInput(value.error());
    values[static_cast<std::size_t>(*field)] = *value;
    return {};
}

}  // namespace

Expected<ParameterValues> readParameterValues(const Invocation& invocation) {
    ParameterValues values;
    if (invocation.has("--file")) {
        const auto read = readFile(invocation.text("--file"));
        if (!read) return tl::unexpected(read.error());
        values = *read;
    }
    thunderbots::ParameterMask given = 0;
    for (const std::string& operand : invocation.operands) {
        if (auto read = readOne(operand, values, given); !read) return tl::unexpected(read.error());
    }
    return values;
}

Outcome saveParameterFile(std::string_view path, const ParameterValues& values) {
    return saveFile(fromView(path), writeParameterFile(values));
}

QJsonObject parametersToJson(const thunderbots::ParameterState& state) {
    QJsonObject json{{QStringLiteral("standing"), QLatin1String(thunderbots::name(state.standing))},
                     {QStringLiteral("parameters"), QJsonValue::Null}};
    if (!state.robot) return json;
    QJsonObject fields;
    for (const ParameterField field : thunderbots::kParameterFields)
        fields[fromView(thunderbots::name(field))] = thunderbots::valueOf(*state.robot, field);
    fields[QStringLiteral("flash_contents")] = fromView(thunderbots::name(state.robot->flash()));
    json[QStringLiteral("parameters")] = fields;
    const auto block = thunderbots::wire::encodeParameters(*state.robot);
    json[QStringLiteral("block")] = QString::fromStdString(toHex(block.view()));
    return json;
}

QList<QStringList> parameterRows(const thunderbots::ParameterState& state) {
    QList<QStringList> rows;
    if (!state.robot) return rows;
    for (const ParameterField field : thunderbots::kParameterFields) {
        rows << QStringList{fromView(thunderbots::name(field)),
                            describeValue(field, thunderbots::valueOf(*state.robot, field))};
    }
    return rows;
}

QString signatureText(std::uint16_t signature) {
    return QStringLiteral("0x%1").arg(signature, 4, 16, QLatin1Char('0'));
}

}  // namespace kickstand::ctl
