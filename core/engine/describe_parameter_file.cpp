#include "core/engine/describe_parameter_file.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

namespace kickstand {
namespace {

using thunderbots::ParameterField;

constexpr int kVersion = 1;
const QLatin1String kKindKey("kickstand");
const QLatin1String kKind("parameters");
const QLatin1String kVersionKey("version");
const QLatin1String kValuesKey("parameters");

tl::unexpected<Error> malformed(std::string detail) {
    return fail(Errc::Malformed, "the parameter file", std::move(detail));
}

QString keyOf(ParameterField field) {
    const std::string_view text = thunderbots::name(field);
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

QJsonValue toJson(ParameterField field, std::uint8_t value) {
    if (field != ParameterField::FlashContents) return value;
    thunderbots::wire::OperationalParameters block;
    block.flashContents = value;
    const std::string_view text = thunderbots::name(block.flash());
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

Result<std::uint8_t> fromJson(ParameterField field, const QJsonValue& value) {
    if (value.isString()) return thunderbots::parseParameter(field, value.toString().toStdString());
    const double number = value.toDouble(-1);
    if (!value.isDouble() || number != std::floor(number) || std::abs(number) > 1e6)
        return fail(Errc::Malformed, std::string(thunderbots::name(field)), "it is no whole number");
    if (auto legal = thunderbots::checkParameter(field, static_cast<int>(number)); !legal)
        return tl::unexpected(std::move(legal.error()));
    return static_cast<std::uint8_t>(number);
}

}  // namespace

QByteArray writeParameterFile(const thunderbots::ParameterValues& values) {
    QJsonObject fields;
    for (const ParameterField field : thunderbots::kParameterFields) {
        if (const auto& value = values[static_cast<std::size_t>(field)])
            fields.insert(keyOf(field), toJson(field, *value));
    }
    return QJsonDocument(QJsonObject{{kKindKey, kKind}, {kVersionKey, kVersion}, {kValuesKey, fields}})
        .toJson();
}

Result<thunderbots::ParameterValues> readParameterFile(const QByteArray& file) {
    if (file.size() > kLongestParameterFile) return malformed("it is too long");
    QJsonParseError parsed;
    const QJsonObject whole = QJsonDocument::fromJson(file, &parsed).object();
    if (parsed.error != QJsonParseError::NoError) return malformed(parsed.errorString().toStdString());
    if (whole.value(kKindKey) != kKind) return malformed("it is no file of parameters");
    if (whole.value(kVersionKey) != kVersion) return malformed("another version of the program wrote it");
    if (!whole.value(kValuesKey).isObject()) return malformed("it holds no parameters");
    const QJsonObject fields = whole.value(kValuesKey).toObject();
    thunderbots::ParameterValues values;
    for (auto entry = fields.begin(); entry != fields.end(); ++entry) {
        const auto field = thunderbots::parameterFieldFromName(entry.key().toStdString());
        if (!field) return fail(Errc::UnknownName, entry.key().toStdString());
        const auto value = fromJson(*field, entry.value());
        if (!value) return tl::unexpected(value.error());
        values[static_cast<std::size_t>(*field)] = *value;
    }
    return values;
}

}  // namespace kickstand
