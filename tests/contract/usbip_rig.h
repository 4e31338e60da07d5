#pragma once

#include <list>
#include <memory>

#include "core/base/fake_scheduler.h"
#include "core/link/usbip/usbip_link.h"
#include "core/usbip/usbip_server.h"
#include "tests/contract/usb_rig.h"
#include "tests/support/usb/memory_stream.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::testing {

/// A server without sockets, and links to it over connections in memory, on the test's own thread and in the
/// time of a fake scheduler.
class UsbipMemoryRig final : public UsbRig {
  public:
    explicit UsbipMemoryRig(const MemoryStreamOptions& options = {});

    /// What finds the device.
    static UsbMatch match();
    static UsbipAddress address() { return {"server", 3240, "1-1"}; }

    std::unique_ptr<UsbLink> makeLink() override;
    std::string port() const override { return toString(address()); }
    FakeScheduler& scheduler() override { return scheduler_; }
    void onLink(const std::function<void()>& action) override { action(); }
    void onDevice(const std::function<void(FakeUsbDevice&)>& action) override { action(device_); }
    bool waitUntil(const std::function<bool()>& done) override {
        return scheduler_.runUntil(done, std::chrono::seconds(60));
    }
    void settle() override { scheduler_.advance(std::chrono::seconds(1)); }

    const UsbipServerReport& report() const { return hall_.report; }

  private:
    void serve(std::unique_ptr<ByteStream> stream);

    FakeScheduler scheduler_;
    const MemoryStreamOptions options_;
    FakeUsbDevice device_;
    UsbipHall hall_;
    std::list<std::unique_ptr<UsbipConnection>> connections_;
};

/// A server and links to it over TCP, each on the thread of its own real scheduler.
class UsbipTcpRig final : public UsbRig {
  public:
    UsbipTcpRig();
    ~UsbipTcpRig() override;

    UsbipAddress address() const { return {"127.0.0.1", port_, "1-1"}; }

    std::unique_ptr<UsbLink> makeLink() override;
    std::string port() const override { return toString(address()); }
    Scheduler& scheduler() override { return linkThread_; }
    void onLink(const std::function<void()>& action) override { linkThread_.run(action); }
    void onDevice(const std::function<void(FakeUsbDevice&)>& action) override;
    bool waitUntil(const std::function<bool()>& done) override { return linkThread_.waitUntil(done); }
    void settle() override;

    /// Ends the server and all its connections.
    void stopServer();
    /// Begins anew, at the same port.
    void startServer();

  private:
    WatchedScheduler deviceThread_;
    WatchedScheduler linkThread_;
    FakeUsbDevice device_;
    std::unique_ptr<UsbipServer> server_;  ///< The device's thread.
    std::uint16_t port_ = 0;
};

}  // namespace kickstand::testing
