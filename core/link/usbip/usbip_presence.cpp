#include "core/link/usbip/usbip_presence.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

constexpr Duration kInterval = std::chrono::milliseconds(500);

}  // namespace

UsbipPresence::UsbipPresence(Scheduler& scheduler, const UsbipAddress& address, const UsbMatch& match,
                             const UsbipConnect& connect, std::function<void()> appeared)
    : scheduler_(scheduler),
      address_(address),
      match_(match),
      connect_(connect),
      appeared_(std::move(appeared)) {}

UsbipPresence::~UsbipPresence() {
    scheduler_.cancel(timer_);
}

void UsbipPresence::start(std::optional<bool> there) {
    stop();
    there_ = there;
    timer_ = scheduler_.callAfter(there ? kInterval : Duration::zero(), [this] { look(); });
}

void UsbipPresence::stop() {
    scheduler_.cancel(timer_);
    looking_.reset();
    client_.reset();
}

void UsbipPresence::look() {
    looking_ = std::make_shared<const bool>(true);
    connect_([this, observed = std::weak_ptr(looking_)](Result<std::unique_ptr<ByteStream>> connected) {
        if (observed.expired()) return;
        if (!connected) return looked(false);
        ask(std::move(*connected));
    });
}

void UsbipPresence::ask(std::unique_ptr<ByteStream> stream) {
    client_ = std::make_unique<UsbipClient>(scheduler_, std::move(stream));
    client_->list(
        [this](const Result<std::vector<usbip::Device>>& devices) { looked(devices && isListed(*devices)); });
}

void UsbipPresence::looked(bool there) {
    looking_.reset();
    client_.reset();
    timer_ = scheduler_.callAfter(kInterval, [this] { look(); });
    if (std::exchange(there_, there) != false || !there) return;
    // A copy, and last, because it may destroy this.
    const auto appeared = appeared_;
    appeared();
}

bool UsbipPresence::isListed(const std::vector<usbip::Device>& devices) const {
    return std::any_of(devices.begin(), devices.end(), [this](const usbip::Device& device) {
        return device.busId == address_.busId && match_.takes(device.vendor, device.product);
    });
}

}  // namespace kickstand
