#pragma once

#include <memory>

#include "core/base/session_host.h"
#include "core/coach/coach_side.h"
#include "core/coach/commands.h"
#include "core/coach/radio_line.h"
#include "core/coach/radio_setup.h"
#include "core/coach/snapshot.h"
#include "core/coach/towrp_side.h"

namespace kickstand::coach {

/// One radio module on a serial line, and the side that this program plays over it. Engine thread.
class Session {
  public:
    using Host = SessionHost<Event>;

    /// Nothing is opened before start().
    Session(Host host, std::unique_ptr<ByteLink> link);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Begins to open the port.
    void start();
    /// Does a command; the answer comes through the host, now or later, exactly once.
    void execute(CommandId id, const Command& command);
    /// The safety step, every 10 ms.
    void step(TimePoint now, bool heartbeatFresh);
    /// STOP has been latched: zero velocity takes the next slot.
    void halt();
    /// Whether a boat is told to move.
    bool active() const { return coach_.moves(); }
    /// Sends zero velocity, waits for its slot, and closes. `done` comes once.
    void shutdown(std::function<void()> done);

    /// Rises whenever snapshot() would show something else.
    std::uint64_t version() const { return coach_.version() + towrp_.version() + line_.version() + version_; }
    Snapshot snapshot() const;

  private:
    void perform(CommandId id, const StartCoach& command);
    void perform(CommandId id, const StartTowrp& command);
    void perform(CommandId id, const EndRole& command);
    void perform(CommandId id, const Pair& command);
    void perform(CommandId id, const Steer& command);
    void perform(CommandId id, const FreeDigital& command);
    void perform(CommandId id, const FreeAnalog& command);
    void perform(CommandId id, const Suppress& command);
    void perform(CommandId id, const Act& command);
    void perform(CommandId id, const SetSeries& command);
    void perform(CommandId id, const Jettison& command);
    void perform(CommandId id, const SetMorale& command);
    void perform(CommandId id, const FindRadio& command);
    void perform(CommandId id, const ApplyRadio& command);

    void open();
    void opened(const Result<ByteLinkInfo>& result);
    void askModule();
    void moduleAnswered(const Result<FoundRadio>& radio);
    void presence(bool present);
    void enter(LinkState state);
    void messageCame(const Received& message);
    void sendMessage(std::uint16_t destination, const wire::Message& message);
    void sideEvent(EventKind kind, int team, std::int64_t code, std::int64_t previous);
    void endRole(Unpairing why);
    void close();
    void waitForStop();
    SideOutput output();
    Result<void> checkRadio() const;
    Result<void> checkRole(wire::Role role, Team team) const;
    Result<void> checkSetup() const;
    /// Answers a command that sets the module, and says how it went.
    void setUp(CommandId id, const Result<FoundRadio>& radio, EventKind done, EventKind failed,
               std::int64_t changes);
    void raise(EventKind kind, int team = -1, std::int64_t code = 0, std::int64_t previous = 0,
               std::string text = {});
    void sample(Signal signal, Team team, double value);

    Host host_;
    std::unique_ptr<ByteLink> link_;
    RadioLine line_;
    RadioSetup setup_;
    CoachSide coach_;
    TowrpSide towrp_;
    LinkState state_ = LinkState::Idle;
    std::optional<Error> error_;
    ByteLinkInfo port_;
    std::optional<FoundRadio> radio_;
    std::vector<std::string> series_;
    bool mustPassZero_ = true;
    bool heartbeatFresh_ = false;
    bool ending_ = false;
    CommandId settingFor_ = 0;  ///< The command that sets the module, not yet answered.
    std::function<void()> shutDown_;
    TimePoint shutDownLimit_{};
    TimerId timer_ = 0;
    std::uint64_t connections_ = 0;
    std::uint64_t version_ = 0;
};

}  // namespace kickstand::coach
