#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>

#include "core/base/latch.h"
#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/usb_link.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/micropacket.h"

namespace kickstand::thunderbots {

/// The OUT half of the state transport (protocol 3.6): one newest drive block for each robot, at most five in
/// a packet, at most one packet on its way. A block that was replaced before it went is never sent: set
/// points do not queue. While STOP is latched every block that goes is a braked one, whatever was asked for.
/// Engine thread.
class StateTransport {
  public:
    /// `failed` is called when the endpoint cannot be brought to take packets any more.
    StateTransport(UsbLink& link, Scheduler& scheduler, const StopLatch& stop,
                   std::function<void(Error)> failed);

    /// Begins to send. Nothing that was set on an earlier connection is left.
    void open();
    /// Forgets everything; transfers are ended by whoever closes the link.
    void close();

    /// What robot 0-15 shall be told from now on; sent as soon as the link takes it if it is news.
    /// Errors: OutOfRange for a block that the wire has no room for.
    Result<void> set(int robot, const wire::DriveBlock& block);
    /// Braked blocks to all sixteen, whether they are news or not.
    void brakeAll();
    /// Sends an empty packet when nothing has gone for 300 ms (protocol 3.5). True when it did.
    bool keepAliveIfDue();
    /// How long the link has taken nothing. Zero while closed.
    Duration silence() const { return open_ ? scheduler_.now() - lastSent_ : Duration::zero(); }
    /// Calls back once: true when everything set so far has been taken by the link (at once where there is
    /// nothing), false when the connection ended before. Several may wait; they are told in their order.
    void whenDrained(std::function<void(bool taken)> drained);

  private:
    void pump();
    void submit(ByteView packet, RobotMask robots);
    void completed(std::uint64_t connection, RobotMask robots, const UsbCompletion& completion);
    void stalled(RobotMask robots);
    void tellIfDrained();

    UsbLink& link_;
    Scheduler& scheduler_;
    const StopLatch& stop_;
    std::function<void(Error)> failed_;
    std::array<wire::DriveBlock, kRobots> wanted_{};
    RobotMask dirty_ = 0;
    int next_ = 0;  ///< The robot whose turn it is when more than five are due.
    bool open_ = false;
    bool inFlight_ = false;
    int stallsInRow_ = 0;
    std::uint64_t connection_ = 0;  ///< Tells late completions of an earlier connection apart.
    TimePoint lastSent_{};
    std::deque<std::function<void(bool)>> drained_;
};

}  // namespace kickstand::thunderbots
