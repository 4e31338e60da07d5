#pragma once

#include <mutex>

#include "core/base/scheduler.h"

namespace kickstand::socket {

/// The way from the sockets' thread to the scheduler's. Any thread.
class Mailbox {
  public:
    explicit Mailbox(Scheduler& scheduler) : scheduler_(&scheduler) {}

    /// Has the scheduler's thread do something; forgotten once the box is closed.
    void post(Scheduler::Callback callback) {
        const std::lock_guard lock(mutex_);
        if (scheduler_ != nullptr) scheduler_->post(std::move(callback));
    }
    /// After this the scheduler is not touched any more.
    void close() {
        const std::lock_guard lock(mutex_);
        scheduler_ = nullptr;
    }

  private:
    std::mutex mutex_;
    Scheduler* scheduler_;
};

}  // namespace kickstand::socket
