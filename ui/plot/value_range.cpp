#include "ui/plot/value_range.h"

namespace kickstand::ui {

namespace {

constexpr double kSmallestPart = 1e-5;
constexpr double kLargest = 1e7;
constexpr double kAir = 0.08;

}  // namespace

ValueRange zoomed(const ValueRange& range, double factor, double value) {
    const double magnitude = std::max({std::abs(range.low), std::abs(range.high), 1.0});
    const double size = std::clamp(range.size() * factor, magnitude * kSmallestPart, kLargest);
    const double low = value - (value - range.low) * (size / range.size());
    return {low, low + size};
}

ValueRange moved(const ValueRange& range, double part) {
    const double by = range.size() * part;
    if (std::abs(range.low + by) > kLargest || std::abs(range.high + by) > kLargest) return range;
    return {range.low + by, range.high + by};
}

ValueRange around(double least, double most, double smallest) {
    const double air = std::max((most - least) * kAir, (smallest - (most - least)) / 2);
    return {least - air, most + air};
}

ValueRange widened(const ValueRange& usual, double least, double most) {
    const double step = usual.size() / 10;
    const double below = std::ceil(std::max(usual.low - least, 0.0) / step);
    const double above = std::ceil(std::max(most - usual.high, 0.0) / step);
    return {usual.low - below * step, usual.high + above * step};
}

}  // namespace kickstand::ui
