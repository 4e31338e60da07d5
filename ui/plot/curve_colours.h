#pragma once

#include <QColor>
#include <cstdint>
#include <vector>

namespace kickstand::ui {

/// How many colours of the Okabe-Ito set can be told from the ground of one theme: seven, and the eighth is
/// the other theme's. Colour never stands alone: every curve is labelled at its end.
inline constexpr int kCurveColours = 7;

/// One of them, for 0 to kCurveColours - 1.
QColor curveColour(int index, bool dark);

/// A colour for each of some units: the same one as long as it can be, and no colour twice among the first
/// seven.
std::vector<int> colourIndices(const std::vector<std::uint16_t>& units);

}  // namespace kickstand::ui
