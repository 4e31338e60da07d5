#pragma once

#include <QJsonObject>
#include <QString>

#include "core/smartdevice/snapshot.h"

namespace kickstand::ctl {

// Smart devices as --json prints them and as people read them.

/// true, 12, 0.5, "a1 b2" for raw bytes, and whole numbers that no double holds as text; null for none.
QJsonValue toJson(const std::optional<smartdevice::wire::Value>& value);
/// "0.5 A", "-" for none.
QString valueText(const smartdevice::ParameterSpec& spec,
                  const std::optional<smartdevice::wire::Value>& value);
/// {"name", "uid", "port", "presence", "dialect", "latency_ms", …, "values": {…}}.
QJsonObject toJson(const smartdevice::DeviceState& device);
QJsonObject toJson(const smartdevice::PortState& port);
/// The values that are known, by name.
QJsonObject valuesToJson(const smartdevice::DeviceState& device, smartdevice::wire::ParameterMask parameters);

}  // namespace kickstand::ctl
