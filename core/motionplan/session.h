#pragma once

#include <memory>
#include <optional>

#include "core/base/session_host.h"
#include "core/link/byte_link.h"
#include "core/motionplan/commands.h"
#include "core/motionplan/events.h"
#include "core/motionplan/model.h"
#include "core/motionplan/snapshot.h"
#include "core/motionplan/station.h"

namespace kickstand::motionplan {

/// One connection to one NXT: the serial line, the station that talks over it, and the rules by which a
/// person's commands may move the robot. Connecting moves nothing and stops nothing: a plan that executes is
/// heard of by its status. Engine thread.
class Session {
  public:
    using Host = SessionHost<Event>;

    /// Nothing is opened before start().
    Session(Host host, std::unique_ptr<ByteLink> link);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Begins to open the line; with Bluetooth that can take seconds.
    void start();
    /// Does a command; the answer comes through the host, now or later, exactly once.
    void execute(CommandId id, const Command& command);
    /// The safety step, every 10 ms.
    void step(TimePoint now, bool heartbeatFresh);
    /// STOP has been latched: what waits is dropped and Stop goes out at once (protocol 6.4).
    void halt();
    /// Whether a plan executes, or may.
    bool active() const { return model_.execution().active(); }
    /// Stops what was started here, waits until the robot has said so, but not for long, and closes. `done`
    /// comes once. Commands are refused from here on, and those under way are answered before it comes.
    void shutdown(std::function<void()> done);

    /// Rises whenever snapshot() would show something else.
    std::uint64_t version() const { return version_; }
    Snapshot snapshot() const;

  private:
    /// How long the robot's word that it has stopped is waited for before the line is closed.
    static constexpr Duration kLastStopLimit = std::chrono::milliseconds(350);

    /// How often unreadable messages are told of at most.
    static constexpr Duration kMalformedEvery = std::chrono::seconds(1);

    void perform(CommandId id, const CreatePlan& command);
    void perform(CommandId id, const UpdatePlan& command);
    void perform(CommandId id, const ExecutePlan& command);
    void perform(CommandId id, const StopPlan& command);
    void perform(CommandId id, const QuerySlot& command);
    void perform(CommandId id, const AdjustSpeed& command);
    void perform(CommandId id, const SetTrigger& command);
    void perform(CommandId id, const ReadTrigger& command);

    Result<void> checkTaken(const Command& command) const;
    /// Asks for the slot first where it is not known, then sends it if the robot would take it.
    void sendToSlot(CommandId id, const wire::Message& message);
    void sendKnown(CommandId id, const wire::Message& message);
    /// What the robot would refuse, by its own error code (protocol 4.10), as far as the slot is known.
    Result<void> checkSlot(const wire::Message& message) const;
    /// The same for Adjust.
    Result<void> checkAdjust(const wire::Message& message) const;
    void submit(CommandId id, Exchange::Request request);
    void answer(CommandId id, const Result<void>& result);
    void ended(const Exchange& exchange);
    void tellFailure(const Exchange& exchange);
    /// Forgets what a failed request may have changed.
    void doubt(const Exchange& exchange);
    /// Stop goes out at once; what waits ends with `why`.
    void sendStop(Errc why);
    void stopEnded(const Exchange& exchange);

    void open();
    void opened(const Result<ByteLinkInfo>& result);
    void presence(bool present);
    void lost();
    void close();
    /// Errors: StopLatched; what it would be refused with, as far as is known now.
    Result<void> maySend(const wire::Message& message);
    void heard(const wire::Message& message, bool belonged);
    void answering(int missed);
    void tellMalformed(TimePoint now);
    /// Asks for the trigger plan by itself, once the robot answers: what a lost connection starts has to be
    /// known before it is lost.
    void askTrigger();
    void raise(EventKind kind, std::int64_t code = 0, std::int64_t previous = 0, std::string text = {});
    Station::Hooks hooks();

    Host host_;
    std::unique_ptr<ByteLink> link_;
    Model model_;
    Station station_;
    LinkState state_ = LinkState::Idle;
    std::optional<Error> error_;
    ByteLinkInfo port_;
    bool answers_ = false;
    bool triggerAsked_ = false;  ///< By askTrigger(), on this connection.
    std::uint8_t nxtStatus_;
    std::optional<CommandId> startAsked_;  ///< The Execute that is not answered yet.
    bool startedHere_ = false;             ///< A plan was started or adjusted by this session.
    bool heartbeatFresh_ = false;
    bool ending_ = false;
    StopState stop_ = StopState::None;
    std::vector<CommandId> stopAskers_;  ///< Who is told how it ends.
    std::uint64_t stops_ = 0;            ///< Each takes the place of the one before.
    TimePoint stopConfirmedAt_{};
    std::function<void()> shutDown_;
    TimerId shutdownDeadline_ = 0;
    std::int64_t malformed_ = 0;  ///< Since they were told of.
    std::string malformedText_;
    TimePoint malformedAt_{};
    std::uint64_t connections_ = 0;
    std::uint64_t version_ = 1;
};

}  // namespace kickstand::motionplan
