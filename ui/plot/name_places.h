#pragma once

#include <QRectF>
#include <optional>
#include <vector>

namespace kickstand::ui {

/// A line across an area that has a name.
struct NamedLine {
    double y = 0;
    double width = 0;  ///< Of its name.
};

/// Where names of one height stand in an area: at its left edge just above their lines, else just below them,
/// moved right past what is taken, no farther than half the area. Nothing for a name that finds no such
/// place, would stand on a name before it or on another line: it would be taken for that one's.
std::vector<std::optional<QRectF>> placeNames(const std::vector<NamedLine>& lines, double height,
                                              const QRectF& area, const std::vector<QRectF>& taken);

}  // namespace kickstand::ui
