#pragma once

#include <array>
#include <cstddef>

#include "ui/plot/time_view.h"

namespace kickstand::ui {

/// Two moments that a person compares. One of them is the one that keys move.
class Cursors {
  public:
    static constexpr int kCount = 2;

    bool isShown() const { return shown_; }
    /// Shows them in the view, at a third and two thirds of it; where they are shown already they come into
    /// it.
    void show(const TimeView& view);
    void hide() { shown_ = false; }

    TimePoint at(int cursor) const { return at_[static_cast<std::size_t>(cursor)]; }
    void put(int cursor, TimePoint time);
    int active() const { return active_; }
    void activate(int cursor) { active_ = cursor; }
    /// Moves the active one by columns of the view; it stays within what is seen.
    void step(std::int64_t columns, const TimeView& view);
    /// The one that lies within `reach` of a moment, the nearer where both do; -1 for none.
    int nearest(TimePoint time, Duration reach) const;
    /// From the first to the second; negative where that lies before.
    Duration delta() const { return at_[1] - at_[0]; }

  private:
    std::array<TimePoint, kCount> at_{};
    int active_ = 0;
    bool shown_ = false;
};

}  // namespace kickstand::ui
