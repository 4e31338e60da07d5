#include "core/base/thread_scheduler.h"

namespace kickstand {
namespace {

std::chrono::steady_clock::time_point toSteady(TimePoint when) {
    return std::chrono::steady_clock::time_point(
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(when.time_since_epoch()));
}

}  // namespace

ThreadScheduler::ThreadScheduler() : thread_([this] { run(); }) {}

ThreadScheduler::~ThreadScheduler() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

TimePoint ThreadScheduler::now() const {
    return TimePoint(
        std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

TimerId ThreadScheduler::callAt(TimePoint when, Callback callback) {
    TimerId id = 0;
    bool first = false;
    {
        const std::lock_guard lock(mutex_);
        first = !heap_.next() || when < *heap_.next();
        id = heap_.add(when, std::move(callback));
    }
    if (first) wake_.notify_one();
    return id;
}

void ThreadScheduler::post(Callback callback) {
    {
        const std::lock_guard lock(mutex_);
        // Now, read under the lock: behind every timer that is already due, so that a stream of posts starves
        // none.
        heap_.add(now(), std::move(callback));
    }
    wake_.notify_one();
}

bool ThreadScheduler::cancel(TimerId id) {
    const std::lock_guard lock(mutex_);
    return heap_.remove(id);
}

void ThreadScheduler::run() {
    threadId_ = std::this_thread::get_id();
    std::unique_lock lock(mutex_);
    while (!ending_) {
        const auto next = heap_.next();
        if (!next) {
            wake_.wait(lock);
            continue;
        }
        Callback due = heap_.takeDue(now());
        if (!due) {
            wake_.wait_until(lock, toSteady(*next));
            continue;
        }
        lock.unlock();
        due();
        due = nullptr;
        lock.lock();
    }
}

}  // namespace kickstand
