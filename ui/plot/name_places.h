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

/// Where names of one height stand in an area: at its left edge above their lines, else below them, moved
/// right past what is taken and past names before, no farther than half the area. Nothing for a name that
/// finds no such place.
std::vector<std::optional<QRectF>> placeNames(const std::vector<NamedLine>& lines, double height,
                                              const QRectF& area, std::vector<QRectF> taken);

}  // namespace kickstand::ui
