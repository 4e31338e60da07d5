#pragma once

#include <QJsonObject>

#include "app/kickstandctl/command.h"
#include "core/thunderbots/parameter_draft.h"
#include "core/thunderbots/parameter_state.h"

namespace kickstand::ctl {

// Parameters as they are typed, kept in files and printed.

/// What was asked for: the values of --file, and over them those of the operands FIELD=VALUE. Exit 2 for what
/// cannot be read, and for a field that is given twice.
Expected<thunderbots::ParameterValues> readParameterValues(const Invocation& invocation);
/// Writes a parameter file, whole or not at all.
Outcome saveParameterFile(std::string_view path, const thunderbots::ParameterValues& values);

/// The block's fields, its bytes and how long they live: {"parameters", "block", "standing"}.
QJsonObject parametersToJson(const thunderbots::ParameterState& state);
/// The same for people, a line a field.
QList<QStringList> parameterRows(const thunderbots::ParameterState& state);
/// "0x1a2b".
QString signatureText(std::uint16_t signature);

}  // namespace kickstand::ctl
