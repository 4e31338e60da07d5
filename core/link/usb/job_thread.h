#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace kickstand::usb {

/// A thread that does one job after another, in order: where a link does what may block.
class JobThread {
  public:
    JobThread() : thread_([this] { work(); }) {}
    /// Does the jobs that are still there, and waits for their end.
    ~JobThread();
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;

    /// Any thread.
    void run(std::function<void()> job);

  private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> jobs_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace kickstand::usb
