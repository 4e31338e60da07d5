#pragma once

#include <QByteArray>

#include "core/base/result.h"
#include "core/thunderbots/parameter_draft.h"

namespace kickstand {

/// The longest file that is read.
inline constexpr qsizetype kLongestParameterFile = qsizetype{64} * 1024;

/// A JSON file of parameters, as resources/help/parameters-file.md describes it, of the values that there
/// are. Any thread.
QByteArray writeParameterFile(const thunderbots::ParameterValues& values);

/// Reads such a file. Errors: Malformed with what cannot be read as its subject and why as its detail;
/// OutOfRange and Malformed of single fields. Any thread.
Result<thunderbots::ParameterValues> readParameterFile(const QByteArray& file);

}  // namespace kickstand
