#include "core/base/fake_scheduler.h"

#include <algorithm>

namespace kickstand {

TimerId FakeScheduler::callAt(TimePoint when, Callback callback) {
    return heap_.add(std::max(when, now_), std::move(callback));
}

void FakeScheduler::post(Callback callback) {
    heap_.add(now_, std::move(callback));
}

bool FakeScheduler::cancel(TimerId id) {
    return heap_.remove(id);
}

void FakeScheduler::advance(Duration span) {
    const TimePoint end = now_ + span;
    while (heap_.next() && *heap_.next() <= end) {
        now_ = std::max(now_, *heap_.next());
        if (const Callback callback = heap_.takeDue(now_)) callback();
    }
    now_ = end;
}

bool FakeScheduler::runUntil(const std::function<bool()>& done, Duration limit) {
    const TimePoint end = now_ + limit;
    while (!done()) {
        if (!heap_.next() || *heap_.next() > end) {
            now_ = end;
            return done();
        }
        now_ = std::max(now_, *heap_.next());
        if (const Callback callback = heap_.takeDue(now_)) callback();
    }
    return true;
}

}  // namespace kickstand
