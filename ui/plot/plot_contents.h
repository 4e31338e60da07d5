#pragma once

#include <QString>
#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/signal_id.h"
#include "core/telemetry/marks.h"
#include "ui/plot/value_range.h"

namespace kickstand::ui {

/// A value that means something, as a line across its area.
struct PlotThreshold {
    double value = 0;
    QString label;
};

/// One of the areas that stand above each other on a shared time axis: all quantities of one unit and size.
struct PlotArea {
    QString title;  ///< With its unit: "Battery V".
    QString unit;
    int decimals = 1;
    ValueRange usual;  ///< Shown until a person zooms; wider while values lie outside.
    std::vector<PlotThreshold>
        thresholds;  ///< From the most important on: where names collide, it keeps its own.
};

/// One quantity over time.
struct PlotCurve {
    SignalId signal;
    int area = 0;  ///< Index of its area.
    QString name;  ///< "3 battery".
    QString tag;   ///< Stands at its end: "3".
    int colour = 0;
};

/// How loud a mark is. One that is not plain keeps its word where room is short.
enum class MarkTone {
    Plain,
    Warning,  ///< Wants attention.
    Danger,   ///< STOP and what failed.
};

/// A mark of the time axis in words.
struct MarkWords {
    QString label;  ///< Beside its line, short.
    QString words;  ///< On hover, with all that is known.
    MarkTone tone = MarkTone::Plain;
};
/// Nothing for a mark that is not shown.
using DescribeMark = std::function<std::optional<MarkWords>(const Mark&)>;
/// Several marks of a kind at about the same time.
struct MarkCount {
    MarkKind kind = MarkKind::Kick;
    int count = 0;
    int units = 0;                 ///< How many different ones they concern.
    std::uint16_t unit = kNoUnit;  ///< The first one.

    friend bool operator==(const MarkCount&, const MarkCount&) = default;
};
/// How they are told together: "16 robots heard".
using CountMarks = std::function<QString(const MarkCount&)>;

/// What time it is, on the clock of the samples and on the wall.
struct PlotClock {
    std::function<TimePoint()> now;
    std::function<std::chrono::system_clock::time_point(TimePoint)> wall;
};

}  // namespace kickstand::ui
