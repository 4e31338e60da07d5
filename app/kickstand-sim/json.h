#pragma once

#include <QJsonObject>

#include "app/kickstandctl/failure.h"

namespace kickstand::sim {

/// With this many digits behind the point: what a person and a script can use.
double rounded(double value, int digits);

/// {"ok": false, "error": {"code", "what", "remedy"}}.
QJsonObject toJson(const ctl::Failure& failure);
/// The failure in such an answer. What was typed wrongly is exit 2, everything else 1.
ctl::Failure failureFrom(const QJsonObject& answer);

/// An object in one line, without its end.
QByteArray compact(const QJsonObject& json);

}  // namespace kickstand::sim
