#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "core/link/usb/libusb_support.h"

namespace kickstand::usb {

/// One libusb context with the thread that waits for its events. Made and destroyed on a thread that may
/// block.
class LibusbContext {
  public:
    /// A device came (true) or went (false). On the event thread, where nothing may block; `device` is valid
    /// during the call.
    using Watcher = std::function<void(libusb_device* device, bool arrived)>;

    /// Errors: Io.
    static Result<std::unique_ptr<LibusbContext>> create();
    /// Ends the event thread and leaves libusb. Every device must have been closed.
    ~LibusbContext();
    LibusbContext(const LibusbContext&) = delete;
    LibusbContext& operator=(const LibusbContext&) = delete;

    libusb_context* get() const { return context_; }
    /// Has `watcher` told of every matching device that comes or goes from now on. False where the system
    /// cannot tell. At most once.
    bool watch(const UsbMatch& match, Watcher watcher);

  private:
    explicit LibusbContext(libusb_context* context);
    void handleEvents();

    libusb_context* context_;
    UsbMatch match_;
    Watcher watcher_;
    std::atomic<bool> ending_{false};
    std::thread events_;
};

}  // namespace kickstand::usb
