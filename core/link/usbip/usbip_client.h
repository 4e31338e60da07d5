#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/socket/byte_stream.h"
#include "core/link/usb_types.h"
#include "core/link/usbip/usbip_wire.h"

namespace kickstand {

/// A client's side of one connection to a USB/IP server: asks for the list of devices, or imports one and
/// then transfers until either side ends it. Knows no sockets. Nothing the server says is trusted: what makes
/// no sense, answers what was not asked or brings more than was asked for ends the connection.
///
/// A server that has said nothing for three seconds while something waits is taken for gone. So that a device
/// which merely has nothing to say is not, the server is asked every second, by an unlink of a transfer that
/// has ended, to which any server answers at once: that also tells how long a way it is.
///
/// Everything on the scheduler's thread; no callback comes from inside a call, and any may destroy the
/// client, which silences it.
class UsbipClient {
  public:
    /// Identifies a transfer of this client. Zero is never given out.
    using Sequence = std::uint32_t;
    using Listed = std::function<void(Result<std::vector<usbip::Device>>)>;
    using Imported = std::function<void(Result<usbip::Device>)>;

    UsbipClient(Scheduler& scheduler, std::unique_ptr<ByteStream> stream);
    ~UsbipClient();
    UsbipClient(const UsbipClient&) = delete;
    UsbipClient& operator=(const UsbipClient&) = delete;

    /// Asks for the devices, once; the connection is of no use afterwards. Errors: Disconnected, TimedOut
    /// where the server says nothing, Malformed, Io where it refuses.
    void list(Listed done);
    /// Asks for a device, once, instead of list(). When it was given, `lost` is called should the connection
    /// end, after every transfer has ended with NoDevice; with Disconnected, TimedOut or Malformed and what
    /// was wrong. Errors of `done`: as list(); NoDevice where the server has none of this name,
    /// ClaimedElsewhere where somebody else has it.
    void import(const std::string& busId, Imported done, std::function<void(const Error&)> lost);

    /// Transfers, after an import. `data` is copied. Each gets one callback: how it ended, Cancelled where it
    /// was unlinked in time, NoDevice where the connection or the device was lost.
    Sequence control(const UsbSetup& setup, ByteView data, UsbCallback done);
    Sequence out(std::uint8_t endpoint, ByteView data, std::uint32_t interval, UsbCallback done);
    Sequence in(std::uint8_t endpoint, std::size_t size, std::uint32_t interval, UsbCallback done);
    /// Asks the server to leave off a transfer; nothing where it has ended.
    void unlink(Sequence sequence);
    /// How long the server took to answer when it was last asked; none before that.
    std::optional<Duration> roundTrip() const { return roundTrip_; }

  private:
    enum class Phase : std::uint8_t { New, Listing, Importing, Transferring, Over };

    struct Transfer {
        bool isIn = false;
        bool unlinked = false;
        std::size_t size = 0;
        UsbCallback done;
    };

    void ask(Phase phase, const usbip::Request& request);
    void received(ByteView bytes);
    /// Takes one message off the front. What it calls back may destroy this.
    usbip::Parse take(ByteView bytes);
    usbip::Parse takeList(ByteView bytes);
    usbip::Parse takeImport(ByteView bytes);
    usbip::Parse takeReply(ByteView bytes);
    usbip::Parse takeUnlinkReply(const usbip::Reply& reply);

    Sequence submit(usbip::Command command, UsbCallback done);
    Sequence nextSequence();
    void send(const usbip::Command& command);
    void finish(Sequence sequence, UsbStatus status, ByteView data, std::size_t actual);
    Sequence sendUnlink(Sequence sequence);
    void probe();
    void tick();
    void lose(const Error& error);
    void loseTransfers();

    Scheduler& scheduler_;
    std::unique_ptr<ByteStream> stream_;
    Phase phase_ = Phase::New;
    Listed listed_;
    Imported imported_;
    std::function<void(const Error&)> lost_;
    std::uint32_t device_ = 0;
    std::vector<std::uint8_t> unread_;  ///< The front of a message that has not come whole.
    std::map<Sequence, Transfer> transfers_;
    std::map<Sequence, Sequence> unlinks_;  ///< From an unlink that waits for its answer to its transfer.
    Sequence lastSequence_ = 0;
    Sequence lastEnded_ = 0;
    TimerId ticker_ = 0;
    int quietTicks_ = 0;
    int ticksToProbe_ = 1;
    Sequence probe_ = 0;  ///< The unlink that only asks.
    TimePoint probedAt_{};
    std::optional<Duration> roundTrip_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
};

}  // namespace kickstand
