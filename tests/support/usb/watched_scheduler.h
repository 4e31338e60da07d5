#pragma once

#include <functional>

#include "core/base/thread_scheduler.h"

namespace kickstand::testing {

/// A real scheduler that asks a question after each of its calls, which is what makes waiting for an answer
/// an event.
class WatchedScheduler final : public Scheduler {
  public:
    TimePoint now() const override { return inner_.now(); }
    TimerId callAt(TimePoint when, Callback callback) override;
    void post(Callback callback) override;
    bool cancel(TimerId id) override { return inner_.cancel(id); }

    /// Does something on the scheduler's thread and waits for its end. Not from there.
    void run(const std::function<void()>& action);
    /// Waits until `done`, asked on the scheduler's thread, holds. False when a watchdog had to end the wait.
    /// Not from there.
    bool waitUntil(const std::function<bool()>& done);

  private:
    Callback watched(Callback callback);

    std::function<bool()> question_;
    ThreadScheduler inner_;
};

}  // namespace kickstand::testing
