#include "tests/support/usb/watched_scheduler.h"

#include <future>
#include <memory>

namespace kickstand::testing {
namespace {

constexpr auto kWatchdog = std::chrono::seconds(30);

}  // namespace

Scheduler::Callback WatchedScheduler::watched(Callback callback) {
    return [this, callback = std::move(callback)] {
        callback();
        if (!question_ || !question_()) return;
        question_ = nullptr;
    };
}

TimerId WatchedScheduler::callAt(TimePoint when, Callback callback) {
    return inner_.callAt(when, watched(std::move(callback)));
}

void WatchedScheduler::post(Callback callback) {
    inner_.post(watched(std::move(callback)));
}

void WatchedScheduler::run(const std::function<void()>& action) {
    // Shared, because this side may return while the other still is in set_value().
    const auto done = std::make_shared<std::promise<void>>();
    post([&action, done] {
        action();
        done->set_value();
    });
    done->get_future().wait();
}

bool WatchedScheduler::waitUntil(const std::function<bool()>& done) {
    const auto held = std::make_shared<std::promise<void>>();
    run([&] {
        question_ = [&done, held] {
            if (!done()) return false;
            held->set_value();
            return true;
        };
    });
    if (held->get_future().wait_for(kWatchdog) == std::future_status::ready) return true;
    bool late = false;
    run([&] {
        late = question_ == nullptr;
        question_ = nullptr;
    });
    return late;
}

}  // namespace kickstand::testing
