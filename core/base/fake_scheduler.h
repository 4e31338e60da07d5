#pragma once

#include "core/base/scheduler.h"
#include "core/base/timer_heap.h"

namespace kickstand {

/// A scheduler whose time passes only when a test says so. Everything runs inside advance() and friends, on
/// the caller's thread. Not thread-safe.
class FakeScheduler final : public Scheduler {
  public:
    TimePoint now() const override { return now_; }
    TimerId callAt(TimePoint when, Callback callback) override;
    void post(Callback callback) override;
    bool cancel(TimerId id) override;

    /// Lets `span` pass: runs every call that falls due, each at its own time, those that they ask for
    /// included.
    void advance(Duration span);
    /// Runs what is due now, without letting time pass.
    void runPending() { advance(Duration::zero()); }
    /// Lets time pass without running anything: the thread was not scheduled, the process stopped. What fell
    /// due meanwhile runs late.
    void stall(Duration span) { now_ += span; }
    /// Lets time pass call by call until `done` holds, for at most `limit`. True when it came to hold.
    bool runUntil(const std::function<bool()>& done, Duration limit);
    /// How many calls are pending: a test's way to see a leak of timers.
    std::size_t pending() const { return heap_.size(); }

  private:
    TimePoint now_{};
    TimerHeap heap_;
};

}  // namespace kickstand
