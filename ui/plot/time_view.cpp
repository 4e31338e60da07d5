#include "ui/plot/time_view.h"

#include <cmath>

namespace kickstand::ui {

void TimeView::setColumns(int columns) {
    columns = std::max(columns, 1);
    if (columns == columns_) return;
    const TimePoint middle = timeAt(0.5);
    columns_ = columns;
    width_ = std::max(span_ / columns_, Duration(1));
    end_ = columnAt(middle, width_) + columns_ / 2 + 1;
    if (following_) follow();
}

void TimeView::follow() {
    following_ = true;
    end_ = columnAt(now_, width_) + 1;
}

void TimeView::advance(TimePoint now) {
    now_ = std::max(now_, now);
    if (following_) follow();
}

void TimeView::setSpan(Duration span) {
    rescale(span, 0.5);
}

void TimeView::zoom(double factor, double place) {
    const double span_s = seconds(span_) * factor;
    rescale(fromSeconds(std::clamp(span_s, seconds(kShortest), seconds(kLongest))), place);
}

void TimeView::rescale(Duration span, double place) {
    span = std::clamp(span, kShortest, kLongest);
    const TimePoint fixed = timeAt(place);
    span_ = span;
    width_ = std::max(span_ / columns_, Duration(1));
    if (following_) {
        follow();
        return;
    }
    const auto before = static_cast<std::int64_t>(std::llround(place * columns_));
    end_ = columnAt(fixed, width_) - before + columns_;
    holdBack();
}

void TimeView::pan(std::int64_t columns) {
    following_ = false;
    end_ += columns;
    holdBack();
}

void TimeView::centre(TimePoint time) {
    following_ = false;
    end_ = columnAt(time, width_) + columns_ / 2 + 1;
}

void TimeView::showFrom(TimePoint time) {
    following_ = false;
    end_ = columnAt(time, width_) + columns_;
    holdBack();
}

void TimeView::holdBack() {
    end_ = std::min(end_, columnAt(now_, width_) + 1 + columns_ / 2);
}

double TimeView::placeOf(TimePoint time) const {
    return seconds(time - begin()) / seconds(width_ * columns_);
}

TimePoint TimeView::timeAt(double place) const {
    return begin() + fromSeconds(place * seconds(width_ * columns_));
}

}  // namespace kickstand::ui
