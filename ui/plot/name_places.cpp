#include "ui/plot/name_places.h"

#include <algorithm>

namespace kickstand::ui {

namespace {

constexpr double kAir = 8;

/// Moves a rectangle right until it touches nothing; false where it leaves what is allowed.
bool movePast(QRectF& rect, const std::vector<QRectF>& taken, double end) {
    for (bool moved = true; moved;) {
        moved = false;
        for (const QRectF& other : taken) {
            if (!rect.intersects(other)) continue;
            rect.moveLeft(other.right() + kAir);
            moved = true;
        }
    }
    return rect.right() <= end;
}

bool crosses(const QRectF& rect, const NamedLine& line) {
    return line.y > rect.top() && line.y < rect.bottom();
}

}  // namespace

std::vector<std::optional<QRectF>> placeNames(const std::vector<NamedLine>& lines, double height,
                                              const QRectF& area, const std::vector<QRectF>& taken) {
    std::vector<std::optional<QRectF>> places;
    places.reserve(lines.size());
    for (const NamedLine& line : lines) {
        std::optional<QRectF> place;
        for (const double top : {line.y - height, line.y + 1}) {
            QRectF rect(area.left(), top, line.width, height);
            if (top < area.top() || rect.bottom() > area.bottom()) continue;
            if (!movePast(rect, taken, area.center().x())) continue;
            const bool isCrossed = std::any_of(
                lines.begin(), lines.end(), [&rect](const NamedLine& other) { return crosses(rect, other); });
            const bool isNamed = std::any_of(places.begin(), places.end(), [&rect](const auto& other) {
                return other && other->intersects(rect);
            });
            if (isCrossed || isNamed) continue;
            place = rect;
            break;
        }
        places.push_back(place);
    }
    return places;
}

}  // namespace kickstand::ui
