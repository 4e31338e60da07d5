#pragma once

#include <cstdint>
#include <unordered_map>

#include "core/base/scheduler.h"

namespace kickstand::thunderbots::sim {

/// Calls that die with their owner. On the scheduler's thread.
class Timers {
  public:
    explicit Timers(Scheduler& scheduler) : scheduler_(scheduler) {}
    ~Timers() { cancelAll(); }
    Timers(const Timers&) = delete;
    Timers& operator=(const Timers&) = delete;

    /// Calls `callback` at `when`, unless it is cancelled first.
    void at(TimePoint when, Scheduler::Callback callback) {
        const std::uint64_t key = ++lastKey_;
        pending_[key] = scheduler_.callAt(when, [this, key, callback = std::move(callback)] {
            // The callback may destroy this object: nothing is touched after it.
            pending_.erase(key);
            callback();
        });
    }
    /// Calls once, unless cancelled by then.
    void after(Duration delay, Scheduler::Callback callback) {
        at(scheduler_.now() + delay, std::move(callback));
    }
    /// Forgets every call that has not come.
    void cancelAll() {
        for (const auto& [key, id] : pending_)
            scheduler_.cancel(id);
        pending_.clear();
    }

  private:
    Scheduler& scheduler_;
    std::uint64_t lastKey_ = 0;
    std::unordered_map<std::uint64_t, TimerId> pending_;
};

/// One call at a time that dies with its owner: asking again replaces it. On the scheduler's thread.
class Timer {
  public:
    explicit Timer(Scheduler& scheduler) : scheduler_(scheduler) {}
    ~Timer() { stop(); }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

    /// Calls at `when` instead of whatever was pending.
    template <class Callback>
    void startAt(TimePoint when, Callback callback) {
        stop();
        id_ = scheduler_.callAt(when, [this, callback] {
            id_ = 0;
            callback();
        });
    }
    /// startAt(), counted from now.
    template <class Callback>
    void start(Duration delay, Callback callback) {
        startAt(scheduler_.now() + delay, callback);
    }
    /// Forgets the pending call.
    void stop() {
        if (id_ != 0) scheduler_.cancel(id_);
        id_ = 0;
    }
    bool running() const { return id_ != 0; }

  private:
    Scheduler& scheduler_;
    TimerId id_ = 0;
};

}  // namespace kickstand::thunderbots::sim
