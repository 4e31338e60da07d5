#include "tests/contract/libusb_rig.h"

#include <future>

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

LibusbRig::LibusbRig(UsbWatchOptions options)
    : options_(options), bus_(std::make_unique<UmockdevBus>(deviceThread_)) {
    bus_->connect(device_, "1-1");
}

LibusbRig::~LibusbRig() {
    bus_.reset();
    // What the bus still had to do on the device's thread happens before the device goes.
    deviceThread_.run([] {});
}

UsbMatch LibusbRig::match() {
    UsbMatch match;
    match.vendor = FakeUsbDevice::kVendor;
    match.product = FakeUsbDevice::kProduct;
    match.interfaces = {0, 1};
    return match;
}

std::unique_ptr<UsbLink> LibusbRig::makeLink(UsbMatch match) {
    return makeLibusbLink(linkThread_, std::move(match), options_);
}

void LibusbRig::onDevice(const std::function<void(FakeUsbDevice&)>& action) {
    deviceThread_.run([&] { action(device_); });
}

void LibusbRig::settle() {
    // There and back twice: an answer may provoke a question.
    for (int round = 0; round < 2; ++round) {
        deviceThread_.run([] {});
        linkThread_.run([] {});
    }
}

}  // namespace kickstand::testing
