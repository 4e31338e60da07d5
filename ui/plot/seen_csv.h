#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "core/telemetry/sample.h"

namespace kickstand::ui {

/// What one curve shows, column for column.
struct SeenCurve {
    QString name;
    std::vector<Column> columns;
};

/// What a plot shows.
struct Seen {
    TimePoint begin{};
    Duration columnWidth{};
    std::vector<SeenCurve> curves;
};

/// The same as a table, one line a column: the time in seconds from the left edge, what the clock on the wall
/// showed then, and of each curve the least and the greatest value in the column. Cells are empty where
/// nothing was known. Numbers have a point whatever the locale.
QString csvOf(const Seen& seen, const std::function<QString(TimePoint)>& clock);

}  // namespace kickstand::ui
