#pragma once

#include <QJsonObject>
#include <QString>
#include <chrono>

#include <tl/expected.hpp>

#include "core/thunderbots/bench_check.h"

namespace kickstand {

// A bench check's limits and its report, as files. Any thread once the application object exists.

/// {"least_battery_V": 15, …}: every limit by its name.
QJsonObject toJson(const thunderbots::CheckLimits& limits);
/// Reads that again. What is left out keeps its default. Otherwise a sentence says what is wrong: not JSON,
/// a name that is no limit's, no number, past its range.
tl::expected<thunderbots::CheckLimits, QString> checkLimitsFromJson(const QByteArray& json);

using WallTime = std::chrono::system_clock::time_point;

/// The report as a value: what was checked, each step with limit, value and verdict, and the sentences.
/// `began`: what the clock on the wall showed.
QJsonObject checkReport(const thunderbots::CheckProgress& progress, WallTime began);
/// The same as a page to read and print: a table for each robot, its sentence above it.
QString checkReportHtml(const thunderbots::CheckProgress& progress, WallTime began);
/// The same as lines of text.
QString checkReportText(const thunderbots::CheckProgress& progress, WallTime began);

}  // namespace kickstand
