#include "ui/plot/cursors.h"

namespace kickstand::ui {

void Cursors::show(const TimeView& view) {
    shown_ = true;
    active_ = 0;
    at_ = {view.timeAt(1.0 / 3), view.timeAt(2.0 / 3)};
}

void Cursors::put(int cursor, TimePoint time) {
    at_[static_cast<std::size_t>(cursor)] = time;
    active_ = cursor;
}

void Cursors::step(std::int64_t columns, const TimeView& view) {
    const TimePoint moved = at(active_) + view.columnWidth() * columns;
    put(active_, std::clamp(moved, view.begin(), view.end()));
}

int Cursors::nearest(TimePoint time, Duration reach) const {
    if (!shown_) return -1;
    const Duration first = std::chrono::abs(at_[0] - time);
    const Duration second = std::chrono::abs(at_[1] - time);
    if (std::min(first, second) > reach) return -1;
    if (first == second) return active_;
    return first < second ? 0 : 1;
}

}  // namespace kickstand::ui
