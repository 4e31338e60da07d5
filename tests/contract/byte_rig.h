#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "core/base/scheduler.h"
#include "core/link/byte_link.h"
#include "tests/support/serial/fake_byte_device.h"

namespace kickstand::testing {

/// What the contract of serial lines is checked on: a device, a way to make links to it, and a way to wait.
class ByteRig {
  public:
    virtual ~ByteRig() = default;

    virtual std::unique_ptr<ByteLink> makeLink() = 0;
    /// The port as links tell it.
    virtual std::string port() const = 0;
    /// Does something on the links' thread and waits for its end.
    virtual void onLink(const std::function<void()>& action) = 0;
    /// Does something on the device's thread and waits for its end.
    virtual void onDevice(const std::function<void(FakeByteDevice&)>& action) = 0;
    /// Waits until `done`, which is asked on the links' thread, holds. False when a watchdog had to end the
    /// wait.
    virtual bool waitUntil(const std::function<bool()>& done) = 0;
    /// As waitUntil(), asked on the device's thread.
    virtual bool waitForDevice(const std::function<bool(const FakeByteDevice&)>& done) = 0;
};

/// Makes a fresh rig for each test.
struct ByteRigFactory {
    const char* link = "";
    std::function<std::unique_ptr<ByteRig>()> make;

    friend void PrintTo(const ByteRigFactory& factory, std::ostream* out) { *out << factory.link; }
};

}  // namespace kickstand::testing
