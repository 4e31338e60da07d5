#pragma once

#include <chrono>

namespace kickstand {

/// A span of time. Nanoseconds, so that nothing is rounded on the way.
using Duration = std::chrono::nanoseconds;

/// The clock that a Scheduler tells: monotonic, starting anywhere. It has no now() on purpose: only a
/// Scheduler knows what time it is, which is what lets a test run a day in seconds.
struct SchedulerClock {
    using duration = Duration;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<SchedulerClock>;
    static constexpr bool is_steady = true;
};
using TimePoint = SchedulerClock::time_point;

/// Seconds as a number, for arithmetic with physical units.
constexpr double seconds(Duration span) {
    return std::chrono::duration<double>(span).count();
}

/// A number of seconds as a Duration.
constexpr Duration fromSeconds(double span_s) {
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(span_s));
}

}  // namespace kickstand
