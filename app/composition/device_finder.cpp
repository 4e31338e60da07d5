#include "app/composition/device_finder.h"

#include <utility>

namespace kickstand {

DeviceFinder::DeviceFinder(Look look) : look_(std::move(look)) {}

DeviceFinder::~DeviceFinder() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void DeviceFinder::find(Scheduler& scheduler, std::function<void(FoundHardware)> found) {
    const std::lock_guard lock(mutex_);
    requests_.push_back({&scheduler, std::move(found)});
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    wake_.notify_all();
}

void DeviceFinder::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        wake_.wait(lock, [this] { return ending_ || !requests_.empty(); });
        if (ending_) return;
        Request request = std::move(requests_.front());
        requests_.pop_front();
        lock.unlock();
        request.scheduler->post(
            [found = std::move(request.found), devices = look_()]() mutable { found(std::move(devices)); });
        lock.lock();
    }
}

}  // namespace kickstand
