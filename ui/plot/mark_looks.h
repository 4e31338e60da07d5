#pragma once

#include <QColor>
#include <QPixmap>

#include "core/telemetry/marks.h"

namespace kickstand::ui {

/// What a trigger that was caught looks like: a mark of the plot's own.
inline constexpr int kTriggerLook = -1;

constexpr int lookOf(MarkKind kind) {
    return static_cast<int>(kind);
}

/// How many there are, from kTriggerLook on.
inline constexpr std::size_t kLooks = static_cast<std::size_t>(lookOf(MarkKind::UnitLost) - kTriggerLook) + 1;

/// The shape that stands above a mark's line. Every look has its own: marks can be told apart without colour.
QPixmap markGlyph(int look, const QColor& ink, double pixelRatio);
/// A line of one pixel across an area, in the dashes of its look.
QPixmap markLine(int look, const QColor& ink, int height, double pixelRatio);

}  // namespace kickstand::ui
