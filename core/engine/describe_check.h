#pragma once

#include <QString>

#include "core/thunderbots/bench_check.h"

namespace kickstand {

// The words for bench checks, for the window, the command line and the report. Any thread once the
// application object exists.

/// "Wheel 2, back left, +": what a step checks.
QString describe(const thunderbots::CheckStep& step);
/// "passed", "not seen".
QString describe(thunderbots::CheckVerdict verdict);
/// What a person is asked about a step; empty for one that is measured alone.
QString questionText(const thunderbots::CheckStep& step);
/// What goes on while a step is at work: "Wheel 2, back left, runs…".
QString workText(const thunderbots::CheckRow& row, thunderbots::CheckStage stage);
/// "15.93 V"; empty where nothing was measured.
QString valueText(const thunderbots::CheckRow& row);
/// "≥ 15.0 V"; empty where there is no limit.
QString limitText(const thunderbots::CheckRow& row);
/// Why a step did not pass, where its value does not say so; else empty.
QString reasonText(const thunderbots::CheckRow& row);
/// "Battery at rest, at least".
QString labelOf(const thunderbots::CheckLimitInfo& info);
/// How a robot's check went, in one sentence.
QString sentenceOf(const thunderbots::CheckProgress& progress, int robot);
/// How the whole check went, in one sentence.
QString sentenceOf(const thunderbots::CheckProgress& progress);

}  // namespace kickstand
