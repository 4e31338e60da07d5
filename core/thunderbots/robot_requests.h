#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/thunderbots/request_channel.h"

namespace kickstand::thunderbots {

/// The firmware requests of sixteen robots (protocol 4.7): a RequestChannel each, independent of one another,
/// on the one message pipe. Engine thread.
class RobotRequests {
  public:
    using Done = RequestChannel::Done;
    using Gate = RequestChannel::Gate;
    /// Hears every response that was asked for, before whoever asked.
    using Listener = std::function<void(int robot, const wire::FirmwareResponse& response)>;

    /// Both outlive it.
    RobotRequests(Scheduler& scheduler, MessagePipe& pipe);

    /// Asks a robot (0-15) something, again and again up to RequestChannel::kAttempts times; as
    /// RequestChannel::ask(). The response holds the alternative that belongs to the request.
    Result<void> ask(int robot, const wire::FirmwareRequest& request, Done done, Gate gate = {});
    /// The same, once.
    Result<void> askOnce(int robot, const wire::FirmwareRequest& request, Done done, Gate gate = {});
    /// Fills the page buffer and programs a page, once. Unanswered: the buffer did not hold what the CRC is
    /// of, or the answer was lost; what the buffer holds is not known then.
    Result<void> program(int robot, const std::vector<wire::FillPageRequest>& fills,
                         const wire::ProgramPageRequest& request, Done done);
    /// Ends what a robot is asked with Cancelled, at once. Nothing where it is asked nothing.
    void cancel(int robot);
    /// Whether a robot is being asked something: another request is refused with RequestPending.
    bool busy(int robot) const { return at(robot).busy(); }

    const RequestState& state(int robot) const { return at(robot).state(); }
    /// Whether it was told to reboot a moment ago, so that losing it is no surprise.
    bool rebooting(int robot) const { return at(robot).rebooting(); }
    /// Rises whenever a state() changes.
    std::uint64_t version() const { return version_; }
    void setListener(Listener listener) { listener_ = std::move(listener); }

    /// A packet of the message IN endpoint; those of other pipes, and damaged ones, are somebody else's.
    void received(ByteView packet);
    /// The dongle has found a robot.
    void found(int robot) { at(robot).found(); }
    /// The dongle has lost a robot, or the link has gone.
    void lost(int robot, Errc why);

  private:
    Result<void> begin(int robot, const std::vector<wire::FillPageRequest>& fills,
                       const wire::FirmwareRequest& request, int attempts, Done done, Gate gate);
    RequestChannel& at(int robot) { return *channels_[static_cast<std::size_t>(robot)]; }
    const RequestChannel& at(int robot) const { return *channels_[static_cast<std::size_t>(robot)]; }

    std::uint64_t version_ = 0;
    std::function<void()> changed_;
    Listener listener_;
    MessageTurns turns_;
    std::vector<std::unique_ptr<RequestChannel>> channels_;
};

}  // namespace kickstand::thunderbots
