#pragma once

#include <future>
#include <memory>

#include "core/base/scheduler.h"

namespace kickstand::sim {

/// Does something on a scheduler's thread and waits for its result. Not from that thread.
template <class Action>
auto runOn(Scheduler& scheduler, Action action) {
    // The task outlives the wait by as long as the thread still needs to leave it.
    auto task = std::make_shared<std::packaged_task<decltype(action())()>>(std::move(action));
    auto result = task->get_future();
    scheduler.post([task] { (*task)(); });
    return result.get();
}

}  // namespace kickstand::sim
