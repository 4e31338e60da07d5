#pragma once

#include <QString>
#include <chrono>
#include <vector>

#include "core/base/time.h"

namespace kickstand::ui {

/// A labelled moment of the time axis.
struct TimeTick {
    TimePoint at{};
    QString label;
};

/// The least round step (5 s, 1 min…) that puts no more than `most` ticks into a span.
Duration tickStep(Duration span, int most);

/// Ticks counted back from the right edge: "−20 s", "−10 s", "now". They stand still while data move past.
std::vector<TimeTick> ticksBefore(TimePoint begin, TimePoint end, Duration step);

/// Ticks at round times of the clock on the wall, which showed `wall` at `begin`: "12:04:30".
std::vector<TimeTick> clockTicks(TimePoint begin, TimePoint end, Duration step,
                                 std::chrono::system_clock::time_point wall);

/// "12:04:03.118", in local time.
QString clockText(std::chrono::system_clock::time_point wall);
/// A length of time with its unit and as many digits as help: "1.284 s", "35.0 ms", "−2 min 3 s".
QString durationText(Duration span);

}  // namespace kickstand::ui
