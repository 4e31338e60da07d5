#pragma once

#include <algorithm>
#include <cmath>

namespace kickstand::ui {

/// What a value axis shows, from its lower to its upper end.
struct ValueRange {
    double low = 0;
    double high = 1;

    double size() const { return high - low; }
    friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// `factor` times as much, about `value`, which stays where it is. Never so little that numbers of single
/// precision would coincide.
ValueRange zoomed(const ValueRange& range, double factor, double value);
/// Moved by a part of its size, upwards where positive.
ValueRange moved(const ValueRange& range, double part);
/// What shows all from `least` to `most` with some air on either side; at least `smallest` high.
ValueRange around(double least, double most, double smallest);

/// `usual`, made wider where needed by steps of a tenth of its size until it shows all from `least` to
/// `most`: values that wander change it seldom.
ValueRange widened(const ValueRange& usual, double least, double most);

/// Rows of pixels of a value axis: 0 at the top.
class ValueRows {
  public:
    ValueRows(const ValueRange& range, int rows) : high_(range.high), scale_((rows - 1) / range.size()) {}

    /// The row of a value; it may lie outside.
    int rowOf(float value) const {
        const double row = (high_ - static_cast<double>(value)) * scale_ + 0.5;
        return static_cast<int>(std::floor(std::clamp(row, -kFarthest, kFarthest)));
    }

  private:
    /// Far outside of any picture, and far inside of what an int holds.
    static constexpr double kFarthest = 1e6;

    double high_;
    double scale_;
};

}  // namespace kickstand::ui
