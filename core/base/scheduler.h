#pragma once

#include <cstdint>
#include <functional>

#include "core/base/time.h"

namespace kickstand {

/// Identifies one pending callAt(). Zero is never given out.
using TimerId = std::uint64_t;

/// Tells the time and calls back: the only source of either in core. All callbacks run one after another on
/// the scheduler's own thread, in order of their time and, where that is equal, in the order they were asked
/// for.
class Scheduler {
  public:
    using Callback = std::function<void()>;

    virtual ~Scheduler() = default;

    /// The present. Any thread.
    virtual TimePoint now() const = 0;

    /// Calls `callback` once, at `when` or as soon after as the thread is free; a time that has passed means
    /// "as soon as possible", never "now, inside this call". Any thread.
    virtual TimerId callAt(TimePoint when, Callback callback) = 0;

    /// Calls `callback` once, as soon as possible, after everything posted before it. Any thread.
    virtual void post(Callback callback) = 0;

    /// Forgets a pending call. True when it will not run any more; false when it has run, runs now, or never
    /// was. Any thread; only on the scheduler's own thread does true or false leave no doubt about what runs
    /// now.
    virtual bool cancel(TimerId id) = 0;

    /// callAt(), counted from now. Any thread.
    TimerId callAfter(Duration delay, Callback callback) {
        return callAt(now() + delay, std::move(callback));
    }
};

}  // namespace kickstand
