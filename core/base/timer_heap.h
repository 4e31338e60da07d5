#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/base/scheduler.h"

namespace kickstand {

/// The pending calls of a scheduler in their order: by time, then by when they were asked for.
/// Not thread-safe: the scheduler that owns it locks.
class TimerHeap {
  public:
    /// Adds a call and gives the id by which it can be removed.
    TimerId add(TimePoint when, Scheduler::Callback callback);
    /// True when the call was still pending.
    bool remove(TimerId id);
    /// The time of the next call, if there is one.
    std::optional<TimePoint> next() const;
    /// Takes the first call that is due at `now`; empty when none is.
    Scheduler::Callback takeDue(TimePoint now);
    std::size_t size() const { return calls_.size(); }

  private:
    using Key = std::pair<TimePoint, TimerId>;
    std::map<Key, Scheduler::Callback> calls_;
    std::unordered_map<TimerId, TimePoint> times_;
    TimerId lastId_ = 0;
};

}  // namespace kickstand
