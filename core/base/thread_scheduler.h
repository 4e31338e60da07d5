#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/base/scheduler.h"
#include "core/base/timer_heap.h"

namespace kickstand {

/// The real scheduler: one std::thread that waits on a condition variable for the next call. Its waits end
/// within some 0.1 ms of the time asked for, where a Qt event loop rounds timers to whole milliseconds, and
/// the thread sanitizer sees every lock. Calls that are pending at destruction are dropped unrun.
class ThreadScheduler final : public Scheduler {
  public:
    /// Begins its thread. Any thread.
    ThreadScheduler();
    /// Waits for the call that runs now and ends the thread. Not from the scheduler's own thread.
    ~ThreadScheduler() override;
    ThreadScheduler(const ThreadScheduler&) = delete;
    ThreadScheduler& operator=(const ThreadScheduler&) = delete;

    TimePoint now() const override;
    TimerId callAt(TimePoint when, Callback callback) override;
    void post(Callback callback) override;
    bool cancel(TimerId id) override;

    /// Whether the caller is on the scheduler's thread. Any thread.
    bool isCurrent() const { return std::this_thread::get_id() == threadId_; }

  private:
    void run();

    std::mutex mutex_;
    std::condition_variable wake_;
    TimerHeap heap_;
    bool ending_ = false;
    std::atomic<std::thread::id> threadId_{};
    std::thread thread_;
};

}  // namespace kickstand
