#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/socket/byte_stream.h"
#include "core/link/usb_host_controller.h"
#include "core/usbip/usbip_exports.h"

namespace kickstand {

/// How much one client may ask of a server before its connection is ended.
struct UsbipLimits {
    std::size_t transfers = 256;                  ///< Waiting at once.
    std::size_t unsentBytes = 1024UL * 1024;      ///< Answers that it has not read.
    Duration silence = std::chrono::seconds(10);  ///< Until it has said what it wants.
    /// After an unplug: how long it has to have asked for nothing more before the connection ends, and when
    /// that is at the latest.
    Duration quiet = std::chrono::milliseconds(250);
    Duration quietMost = std::chrono::seconds(2);
};

/// What a server has seen, for people and tests.
struct UsbipServerReport {
    std::uint64_t connections = 0;
    std::uint64_t refused = 0;    ///< Connections that were one too many.
    std::uint64_t malformed = 0;  ///< Connections ended because no sense could be made of them.
    std::uint64_t overrun = 0;    ///< Connections ended at one of UsbipLimits.
    std::uint64_t imports = 0;
    std::uint64_t transfers = 0;
    std::uint64_t unlinked = 0;  ///< Transfers that the client left off in time.
    bool inUse = false;          ///< Somebody has imported a device at this moment.
};

/// What all connections of a server share. On the scheduler's thread.
struct UsbipHall {
    UsbipExports exports;
    UsbipServerReport report{};                          ///< Without inUse, which the exports know.
    std::function<void(const std::string& line)> log{};  ///< May be empty.
};

/// One client's conversation with a USB/IP server: a list, or an import and then transfers until either side
/// ends it. Knows no sockets. What the client sends may be anything; what makes no sense ends the connection.
/// A device that is unplugged ends its transfers with ESHUTDOWN, and so those that are asked for afterwards;
/// the connection ends when the client has stopped asking. (Linux forgets a transfer that it is told to leave
/// off before it could send it when the connection ends just then, and whoever waits for that transfer hangs
/// for good.) When the client goes its transfers are dropped and the device is left unconfigured, as by a bus
/// that loses its host: a dongle switches its radios off. Everything on the scheduler's thread.
class UsbipConnection {
  public:
    /// `scheduler` is that of the models. It and `hall` must outlive the connection. `ended` is called once,
    /// when all is over, never from inside another call; the connection may be destroyed there.
    UsbipConnection(Scheduler& scheduler, std::unique_ptr<ByteStream> stream, UsbipHall& hall,
                    const UsbipLimits& limits, std::function<void()> ended);
    /// Ends the conversation without a word, and calls nobody.
    ~UsbipConnection();
    UsbipConnection(const UsbipConnection&) = delete;
    UsbipConnection& operator=(const UsbipConnection&) = delete;

    /// Transfers that the client waits for.
    std::size_t waiting() const { return transfers_.size(); }

  private:
    struct Transfer {
        UsbTransferId id = 0;
        bool isIn = false;
        std::optional<std::uint32_t> unlinkedBy;  ///< The sequence number of the command that left it off.
    };

    void received(ByteView bytes);
    usbip::Parse takeMessage(ByteView bytes);
    usbip::Parse takeRequest(ByteView bytes);
    usbip::Parse takeCommand(ByteView bytes);
    void listDevices();
    void import(const std::string& busId);
    void attachedChanged(bool attached);
    void releaseDevice();
    void lingerOn();
    void refuse(const usbip::Command& command);
    void submit(const usbip::Command& command);
    UsbTransferId start(const usbip::Command& command, UsbCallback done);
    UsbTransferId startControl(const usbip::Command& command, UsbCallback done);
    void finished(std::uint32_t sequence, const UsbCompletion& completion);
    void unlink(const usbip::Command& command);
    void reply(const usbip::Reply& reply, ByteView data = {});
    void send(ByteView bytes);
    void endMalformed(const std::string& why);
    void endOverrun(const std::string& why);
    void end(const std::string& why);
    void leave();
    void log(const std::string& what) const;

    Scheduler& scheduler_;
    std::unique_ptr<ByteStream> stream_;
    UsbipHall& hall_;
    const UsbipLimits limits_;
    std::function<void()> ended_;
    const std::uint64_t number_;  ///< By which the log tells clients apart.
    bool over_ = false;
    TimerId silenceTimer_ = 0;
    std::optional<TimePoint> unpluggedAt_;  ///< When what it had imported went.
    std::uint32_t deviceId_ = 0;            ///< What it has imported, or had.
    TimerId quietTimer_ = 0;
    std::vector<std::uint8_t> unread_;  ///< The front of a message that has not come whole.
    UsbipExports::Entry* imported_ = nullptr;
    std::map<std::uint32_t, Transfer> transfers_;  ///< By sequence number.
    std::unique_ptr<UsbHostController> controller_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
};

}  // namespace kickstand
