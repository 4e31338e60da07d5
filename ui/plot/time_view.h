#pragma once

#include "ui/plot/columns.h"

namespace kickstand::ui {

/// Which stretch of time is seen, as columns of pixels, and whether it goes along with the present. It
/// changes what is seen and never what is recorded.
class TimeView {
  public:
    static constexpr Duration kShortest = std::chrono::milliseconds(50);
    static constexpr Duration kLongest = std::chrono::hours(12);

    /// How many columns there are to see, at least one. The span stays about the same, and so does the edge
    /// that follows, or else the middle.
    void setColumns(int columns);
    int columns() const { return columns_; }
    /// What one column stands for.
    Duration columnWidth() const { return width_; }

    bool isFollowing() const { return following_; }
    /// The right edge goes along with the present.
    void follow();
    /// Stays where it is.
    void pause() { following_ = false; }
    /// The present is this. It never goes back.
    void advance(TimePoint now);
    TimePoint now() const { return now_; }

    /// What was asked for last; what is seen differs from it by less than a nanosecond a column.
    Duration span() const { return span_; }
    void setSpan(Duration span);
    /// Makes the span `factor` times as long. Where it follows, the right edge stays; else what is at `place`
    /// (0: left edge, 1: right edge).
    void zoom(double factor, double place);
    /// Moves by columns, later where positive, no further than half into the future. It no longer follows.
    void pan(std::int64_t columns);
    /// Moves so that this moment is in the middle. It no longer follows.
    void centre(TimePoint time);
    /// Moves so that the left edge is here. It no longer follows.
    void showFrom(TimePoint time);

    /// The column that centre() puts a moment into.
    std::int64_t middle() const { return end_ - columns_ / 2 - 1; }
    ColumnSpan shown() const { return {end_ - columns_, end_}; }
    TimePoint begin() const { return startOf(end_ - columns_, width_); }
    TimePoint end() const { return startOf(end_, width_); }
    /// Where a moment lies: 0 at the left edge, 1 at the right edge.
    double placeOf(TimePoint time) const;
    TimePoint timeAt(double place) const;

  private:
    void rescale(Duration span, double place);
    void holdBack();

    int columns_ = 1;
    Duration span_ = std::chrono::seconds(60);
    Duration width_ = std::chrono::seconds(60);
    std::int64_t end_ = 0;
    TimePoint now_{};
    bool following_ = true;
};

}  // namespace kickstand::ui
