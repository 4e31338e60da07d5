#pragma once

#include <QJsonObject>
#include <span>
#include <string>

#include "app/kickstandctl/failure.h"

namespace kickstand::sim {

/// The request that "ball 3 1", "e-stop stop" or "kill all" is, by what the simulator says there is to do
/// (its answer to "actions"). Values are left for it to judge. Everything wrong is exit 2.
ctl::Expected<QJsonObject> actionRequest(std::span<const std::string> words, const QJsonObject& actions);

/// The number of a unit, or "all" where that is allowed. `unitName` is what it is a number of.
ctl::Expected<QJsonValue> readUnit(const std::string& word, const QString& unitName, bool allowAll);

}  // namespace kickstand::sim
