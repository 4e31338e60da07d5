#include "core/base/timer_heap.h"

namespace kickstand {

TimerId TimerHeap::add(TimePoint when, Scheduler::Callback callback) {
    const TimerId id = ++lastId_;
    calls_.emplace(Key{when, id}, std::move(callback));
    times_.emplace(id, when);
    return id;
}

bool TimerHeap::remove(TimerId id) {
    const auto found = times_.find(id);
    if (found == times_.end()) return false;
    calls_.erase(Key{found->second, id});
    times_.erase(found);
    return true;
}

std::optional<TimePoint> TimerHeap::next() const {
    if (calls_.empty()) return std::nullopt;
    return calls_.begin()->first.first;
}

Scheduler::Callback TimerHeap::takeDue(TimePoint now) {
    if (calls_.empty() || calls_.begin()->first.first > now) return {};
    auto node = calls_.extract(calls_.begin());
    times_.erase(node.key().second);
    return std::move(node.mapped());
}

}  // namespace kickstand
