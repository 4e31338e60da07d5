#pragma once

#include <vector>

#include "core/link/byte_device_model.h"

namespace kickstand::testing {

/// A device on a serial line that notes what happens to it, and sends what it is told to.
class FakeByteDevice final : public ByteDeviceModel {
  public:
    bool attached() const override { return attached_; }
    void setListener(ByteDeviceListener* listener) override { listener_ = listener; }
    void lineOpened(Baud baud) override;
    void lineClosed() override;
    void lineBaudChanged(Baud baud) override;
    void hostSent(ByteView bytes) override;

    /// Answers everything with itself from now on.
    void setEcho(bool echo) { echo_ = echo; }
    void send(ByteView bytes);
    void plug(bool in);

    const std::vector<std::uint8_t>& received() const { return received_; }
    int opened() const { return opened_; }
    int closed() const { return closed_; }
    bool isOpen() const { return opened_ > closed_; }
    Baud baud() const { return baud_; }
    /// What no listener may do to a device that is pulled out, or closed.
    int misuses() const { return misuses_; }

  private:
    ByteDeviceListener* listener_ = nullptr;
    std::vector<std::uint8_t> received_;
    bool attached_ = true;
    bool echo_ = false;
    int opened_ = 0;
    int closed_ = 0;
    int misuses_ = 0;
    Baud baud_ = 0;
};

}  // namespace kickstand::testing
