#include "core/link/usb/libusb_context.h"

#include <chrono>

namespace kickstand::usb {
namespace {

/// The end of the thread interrupts its wait, so this bounds nothing; it only has to be finite.
constexpr timeval kLongestWait{.tv_sec = 60, .tv_usec = 0};
/// A pause after an error of the event loop, which would otherwise turn as fast as it can.
constexpr auto kErrorPause = std::chrono::milliseconds(10);

}  // namespace

Result<std::unique_ptr<LibusbContext>> LibusbContext::create() {
    libusb_context* context = nullptr;
    if (const int result = libusb_init(&context); result != LIBUSB_SUCCESS) return failWith(result, "libusb");
    return std::unique_ptr<LibusbContext>(new LibusbContext(context));
}

LibusbContext::LibusbContext(libusb_context* context)
    : context_(context), events_([this] { handleEvents(); }) {}

LibusbContext::~LibusbContext() {
    ending_ = true;
    libusb_interrupt_event_handler(context_);
    events_.join();
    libusb_exit(context_);
}

bool LibusbContext::watch(const UsbMatch& match, Watcher watcher) {
    if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) == 0) return false;
    match_ = match;
    watcher_ = std::move(watcher);
    const auto told = [](libusb_context*, libusb_device* device, libusb_hotplug_event event, void* self) {
        const auto& context = *static_cast<LibusbContext*>(self);
        if (matches(device, context.match_))
            context.watcher_(device, event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED);
        return 0;
    };
    return libusb_hotplug_register_callback(
               context_, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
               match.vendor, match.otherProduct ? LIBUSB_HOTPLUG_MATCH_ANY : match.product,
               LIBUSB_HOTPLUG_MATCH_ANY, told, this, nullptr) == LIBUSB_SUCCESS;
}

void LibusbContext::handleEvents() {
    while (!ending_) {
        timeval longest = kLongestWait;
        const int result = libusb_handle_events_timeout_completed(context_, &longest, nullptr);
        if (result != LIBUSB_SUCCESS && result != LIBUSB_ERROR_INTERRUPTED && !ending_)
            std::this_thread::sleep_for(kErrorPause);
    }
}

}  // namespace kickstand::usb
