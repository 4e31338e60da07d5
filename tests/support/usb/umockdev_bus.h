#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include <umockdev.h>

#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"

namespace kickstand::testing {

/// A USB bus on which device models stand where libusb looks for real devices: in this process, and in
/// programs that are started from it with its UMOCKDEV_DIR. The test runs under umockdev-wrapper. One bus at
/// a time in a process, and before anything of libusb.
///
/// umockdev gives up where a device comes or goes just while a program begins or ends to listen. So keep one
/// link for as long as devices move: libusb listens from a process's first context to its last.
class UmockdevBus {
  public:
    /// Whether a program may open a device.
    enum class Permission : std::uint8_t { Granted, Denied };

    /// `scheduler` is the one of the models: a real one, and all calls here come from another thread than its
    /// own.
    explicit UmockdevBus(Scheduler& scheduler);
    /// Takes everything off the bus.
    ~UmockdevBus();
    UmockdevBus(const UmockdevBus&) = delete;
    UmockdevBus& operator=(const UmockdevBus&) = delete;

    /// Connects a model with a port, "1-1" or "1-2.3". From then on it is plugged in and unplugged as it says
    /// of itself, each time with a new device number. It must stay until disconnect() or the end of the bus.
    /// Returns when programs can find it.
    void connect(UsbDeviceModel& model, const std::string& port, Permission permission = Permission::Granted);
    /// Takes a model off, unplugging it where it is plugged in.
    void disconnect(const std::string& port);

  private:
    class Port;

    void addHubsBefore(const std::string& place);
    /// Makes a device known to udev and to whoever reads sysfs.
    void add(const std::string& place, unsigned number, ByteView descriptors);
    void onModels(const std::function<void()>& action);

    struct Unref {
        void operator()(void* object) const { g_object_unref(object); }
    };

    Scheduler& scheduler_;
    std::unique_ptr<UMockdevTestbed, Unref> testbed_;
    std::string root_;
    unsigned lastNumber_ = 1;
    std::set<std::string> hubs_;
    std::map<std::string, std::unique_ptr<Port>> ports_;
};

}  // namespace kickstand::testing
