#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include <umockdev.h>

#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"

namespace kickstand::testing {

/// The device node of one plugged-in device: a FIFO, which is writable, as usbfs has it, exactly while there
/// is something to reap. Any thread.
class UsbfsNode {
  public:
    /// Makes the FIFO at `path`, a real one.
    explicit UsbfsNode(const std::string& path);
    ~UsbfsNode();
    UsbfsNode(const UsbfsNode&) = delete;
    UsbfsNode& operator=(const UsbfsNode&) = delete;

    void setReapable(bool reapable);

  private:
    std::string path_;
    int fifo_ = -1;
    bool reapable_ = true;
};

/// What the kernel's usbfs is between a program and one device, from its plugging in to its going: answers
/// the ioctls that libusb makes, and moves packets between them and a device model. Ioctls come on umockdev's
/// thread; the model is asked on its own alone.
class UsbfsDevice : public std::enable_shared_from_this<UsbfsDevice> {
  public:
    /// `configured` hears of each new configuration, on the model's thread.
    UsbfsDevice(Scheduler& scheduler, UsbDeviceModel& model, const std::string& nodePath,
                std::function<void(std::uint8_t)> configured);
    ~UsbfsDevice();
    UsbfsDevice(const UsbfsDevice&) = delete;
    UsbfsDevice& operator=(const UsbfsDevice&) = delete;

    /// Answers one ioctl, now or later. umockdev's thread.
    void answer(UMockdevIoctlClient* client);
    /// The model has something to say. Model's thread.
    void endpointReady(std::uint8_t endpoint);
    /// The device is gone: everything ends, nothing else is taken. Model's thread.
    void hangUp();

  private:
    struct Urb;
    using UrbPointer = std::shared_ptr<Urb>;
    /// Tells programs apart; never followed.
    using Owner = const void*;

    // umockdev's thread.
    /// Has everything of a program given back when it ends without a word.
    void watch(UMockdevIoctlClient* client);
    void submit(UMockdevIoctlClient* client);
    void reap(UMockdevIoctlClient* client);
    /// Has the model's thread do something that ends in an errno, and completes the ioctl with it.
    void completeOnModel(UMockdevIoctlClient* client, std::function<int()> action);

    // The model's thread.
    int take(const UrbPointer& urb);
    int discard(Owner owner, unsigned long address);
    int claim(Owner owner, std::uint8_t interface);
    int configure(std::uint8_t value);
    int clearHalt(std::uint8_t endpoint);
    void forget(Owner owner);
    void move(std::uint8_t endpoint);
    bool exchange(Urb& urb);
    void finish(const UrbPointer& urb, int status);

    Scheduler& scheduler_;
    UsbDeviceModel& model_;
    std::function<void(std::uint8_t)> configured_;

    // The model's thread.
    bool gone_ = false;
    std::map<std::uint8_t, std::deque<UrbPointer>> waiting_;
    std::map<std::uint8_t, Owner> claims_;

    std::mutex mutex_;
    UsbfsNode node_;
    std::deque<UrbPointer> finished_;
};

}  // namespace kickstand::testing
