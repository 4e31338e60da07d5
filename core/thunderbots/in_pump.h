#pragma once

#include <array>
#include <functional>

#include "core/base/error.h"
#include "core/link/usb_link.h"

namespace kickstand::thunderbots {

/// Keeps IN transfers pending on one endpoint, so that what a dongle sends is taken at once (protocol 3.2).
/// The bytes reach the model through the tap; whoever steers the start-up may look at them too. Engine
/// thread.
class InPump {
  public:
    /// `depth` transfers of `packetBytes` are kept pending. `received` sees every packet; `failed` comes when
    /// the endpoint stalled or failed more often in a row than is tried again.
    InPump(UsbLink& link, std::uint8_t endpoint, std::size_t packetBytes, int depth,
           std::function<void(ByteView)> received, std::function<void(Error)> failed);

    /// Begins to ask, on a link that has been opened.
    void open();
    /// Asks for nothing more; pending transfers are ended by whoever closes the link.
    void close();

  private:
    void ask();
    void completed(std::uint64_t connection, const UsbCompletion& completion);
    void recover();

    UsbLink& link_;
    const std::uint8_t endpoint_;
    const std::size_t packetBytes_;
    const int depth_;
    std::function<void(ByteView)> received_;
    std::function<void(Error)> failed_;
    bool open_ = false;
    bool clearing_ = false;
    int pending_ = 0;
    int failuresInRow_ = 0;
    std::uint64_t connection_ = 0;
};

}  // namespace kickstand::thunderbots
