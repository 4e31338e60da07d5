#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/scheduler.h"
#include "core/engine/link_provider.h"

namespace kickstand {

/// Looks for devices on a thread of its own, which begins with the first request: looking at the bus can
/// block.
class DeviceFinder {
  public:
    using Look = std::function<FoundHardware()>;

    /// `look` is called on the finder's thread.
    explicit DeviceFinder(Look look);
    /// Waits for the look that is under way; requests that wait are dropped.
    ~DeviceFinder();
    DeviceFinder(const DeviceFinder&) = delete;
    DeviceFinder& operator=(const DeviceFinder&) = delete;

    /// Looks, then posts `found` to the scheduler, which must outlive this. Any thread.
    void find(Scheduler& scheduler, std::function<void(FoundHardware)> found);

  private:
    struct Request {
        Scheduler* scheduler;
        std::function<void(FoundHardware)> found;
    };
    void run();

    const Look look_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Request> requests_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace kickstand
