#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/time.h"

namespace kickstand {

/// A sign of life that somebody must keep giving: the window's, or a running command's lease. The engine's
/// safety step lets robots move only while it is fresh. It hands over nothing but a time, so relaxed order is
/// enough. All of it may be called from any thread and never waits.
class Heartbeat {
  public:
    /// "Alive at `now`." The latest beat counts, in whichever order threads give theirs.
    void beat(TimePoint now) {
        const std::int64_t time = now.time_since_epoch().count();
        std::int64_t last = last_.load(std::memory_order_relaxed);
        while (last < time && !last_.compare_exchange_weak(last, time, std::memory_order_relaxed)) {
        }
    }
    /// Ends it at once: a lease given back, a window that closes. Not fresh again before the next beat.
    void withdraw() { last_.store(kNever, std::memory_order_relaxed); }

    /// The latest beat; empty when there was none since the start or the last withdraw().
    std::optional<TimePoint> last() const {
        const std::int64_t time = last_.load(std::memory_order_relaxed);
        if (time == kNever) return std::nullopt;
        return TimePoint(Duration(time));
    }
    /// Whether the latest beat is at most `limit` old at `now`. A beat from after `now`, as another thread's
    /// may be, is.
    bool fresh(TimePoint now, Duration limit) const {
        const std::optional<TimePoint> beaten = last();
        return beaten && now - *beaten <= limit;
    }

  private:
    static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min();
    std::atomic<std::int64_t> last_{kNever};
};

}  // namespace kickstand
