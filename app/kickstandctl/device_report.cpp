#include "app/kickstandctl/device_report.h"

#include <type_traits>

#include "app/kickstandctl/json.h"

namespace kickstand::ctl {
namespace {

using smartdevice::DeviceState;
using smartdevice::wire::Value;

constexpr qint64 kWholeInADouble = qint64{1} << 53;

QString text(const std::string& held) {
    return QString::fromStdString(held);
}

}  // namespace

QJsonValue toJson(const std::optional<Value>& value) {
    if (!value) return QJsonValue::Null;
    return std::visit(
        [&value](const auto& held) -> QJsonValue {
            using T = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<T, bool>) {
                return held;
            } else if constexpr (std::is_floating_point_v<T>) {
                // The shortest number that reads as the same value, rather than a float's tail of digits.
                return QString::fromStdString(smartdevice::wire::toText(*value)).toDouble();
            } else if constexpr (std::is_integral_v<T>) {
                const auto wide = static_cast<qint64>(held);
                const bool exact =
                    wide <= kWholeInADouble && wide >= -kWholeInADouble && (std::is_signed_v<T> || wide >= 0);
                if (exact) return wide;
                return text(smartdevice::wire::toText(*value));
            } else {
                return text(smartdevice::wire::toText(*value));
            }
        },
        *value);
}

QString valueText(const smartdevice::ParameterSpec& spec, const std::optional<Value>& value) {
    if (!value) return QStringLiteral("-");
    const QString shown = text(smartdevice::wire::toText(*value));
    return spec.unit.empty() ? shown : shown + QLatin1Char(' ') + text(spec.unit);
}

QJsonObject valuesToJson(const DeviceState& device, smartdevice::wire::ParameterMask parameters) {
    QJsonObject values;
    for (std::size_t i = 0; i < device.parameters.size(); ++i) {
        if ((parameters >> i & 1) != 0 && device.parameters[i].value)
            values[text(device.spec->parameters[i].name)] = toJson(device.parameters[i].value);
    }
    return values;
}

QJsonObject toJson(const DeviceState& device) {
    QJsonObject json{{QStringLiteral("device"), device.number},
                     {QStringLiteral("name"), text(device.spec->name)},
                     {QStringLiteral("known"), device.spec->known},
                     {QStringLiteral("uid"), text(smartdevice::wire::toText(device.uid))},
                     {QStringLiteral("dialect"), QLatin1String(smartdevice::wire::name(device.uid.dialect))},
                     {QStringLiteral("port"), text(device.port)},
                     {QStringLiteral("presence"), QLatin1String(smartdevice::name(device.presence))},
                     {QStringLiteral("delay_ms"), device.delay_ms},
                     {QStringLiteral("disabled"), device.disabled},
                     {QStringLiteral("damaged_frames"), static_cast<qint64>(device.line.faults())},
                     {QStringLiteral("latency_ms"), QJsonValue::Null},
                     {QStringLiteral("latency_p99_ms"), QJsonValue::Null},
                     {QStringLiteral("values"), valuesToJson(device, 0xFFFF)}};
    if (device.latency) {
        json[QStringLiteral("latency_ms")] = rounded(seconds(device.latency->median) * 1000);
        json[QStringLiteral("latency_p99_ms")] = rounded(seconds(device.latency->p99) * 1000);
    }
    return json;
}

QJsonObject toJson(const smartdevice::PortState& port) {
    QJsonObject json{{QStringLiteral("port"), text(port.name)},
                     {QStringLiteral("phase"), QLatin1String(smartdevice::name(port.phase))},
                     {QStringLiteral("device"), port.device < 0 ? QJsonValue() : QJsonValue(port.device)},
                     {QStringLiteral("error"), QJsonValue::Null}};
    if (port.error) json[QStringLiteral("error")] = toJson(*port.error);
    return json;
}

}  // namespace kickstand::ctl
