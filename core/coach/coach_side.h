#pragma once

#include <deque>
#include <optional>

#include "core/base/result.h"
#include "core/coach/deadlines.h"
#include "core/coach/packet_slots.h"
#include "core/coach/side.h"

namespace kickstand::coach {

/// The COACH of a team: its states, timers, repetitions and its queue (coach protocol 5, 6). Knows no radio:
/// what it sends goes to its output, what came is told to it. The scheduler's thread.
class CoachSide {
  public:
    CoachSide(Scheduler& scheduler, SideOutput output);
    CoachSide(const CoachSide&) = delete;
    CoachSide& operator=(const CoachSide&) = delete;

    /// Begins: Startup.
    void begin(Team team, wire::TeamColor color);
    /// Ends. A boat that it is paired with gets zero in the next slot; then nothing is sent any more. Over a
    /// lost link nothing is sent at once.
    void end(Unpairing why);
    /// The radio has been opened: its first slot is a packet's gap from now.
    void linkOpened() { slots_.rest(); }
    /// A message came.
    void received(const Received& message);

    /// Asks a boat that is available to obey. Errors: BadArgument unless it is not paired; RobotNotAlive
    /// (with the team as `got`) where it was not heard to be available within kPairedSilence.
    Result<void> pair(Team boat);
    /// Where to go. Errors: NotPaired; OutOfRange; StopLatched where it is not zero.
    Result<void> steer(const wire::Velocity& velocity);
    /// Errors, of these four: NotPaired; of the free commands also StopLatched, and QueueFull where too many
    /// wait.
    Result<void> freeDigital();
    /// OutOfRange besides, beyond ±100 %.
    Result<void> freeAnalog(int percent);
    /// Done as well where no mutiny is known of.
    Result<void> suppress();
    Result<void> jettison();
    /// One action of the series of `length`: the right ones in order suppress the mutiny, a wrong one begins
    /// the series anew. NotPaired; BadArgument where there is no mutiny.
    Result<void> act(std::size_t action, std::size_t length);

    /// STOP: zero velocity in the next slot, and nothing but zero until released.
    void halt();
    void release() { halted_ = false; }
    /// Whether the zero velocity of a STOP still waits for its slot.
    bool stopWaits() const { return stopFor_.has_value(); }

    CoachState state() const { return state_; }
    bool moves() const { return state_ == CoachState::Paired && !wanted_.isZero(); }
    /// Rises whenever view() would give something else.
    std::uint64_t version() const { return version_; }
    CoachView view() const;

  private:
    static constexpr std::size_t kFreeLimit = 8;

    void expired(TimerKind kind);
    bool sendNext();
    bool sendUrgent();
    void sendVelocity(Team boat, const wire::Velocity& velocity);
    void send(Team boat, wire::Opcode opcode, std::uint8_t parameter);
    void sendAssertion();
    bool velocityIsOverdue() const;
    bool velocityIsLate() const;
    wire::Velocity steered() const { return halted_ ? wire::Velocity() : wanted_; }
    void wantVelocity();
    HeardBoat& heard(const Received& message);
    void result(const Received& message);
    void moraleCame(const Received& message);
    void replyCame();
    void mutinyNoticed();
    void endMutiny();
    void paired(Team boat);
    void unpair(Unpairing why);
    void pairingFailed(Errc why, std::int64_t coach);
    void enter(CoachState state);
    Result<void> checkPaired() const;
    Result<void> checkFree() const;
    void tell(EventKind kind, int team, std::int64_t code = 0, std::int64_t previous = 0);

    Scheduler& scheduler_;
    SideOutput output_;
    Deadlines deadlines_;
    PacketSlots slots_;
    CoachState state_ = CoachState::Off;
    Team team_ = 0;
    wire::TeamColor color_ = wire::TeamColor::Red;
    std::optional<Team> boat_;
    std::vector<HeardBoat> boats_;
    bool halted_ = false;

    // What waits for a slot, most urgent first.
    std::optional<Team> stopFor_;
    bool suppressWaits_ = false;
    std::optional<Team> jettisonFor_;
    bool assertWaits_ = false;
    std::deque<wire::Message> free_;
    std::optional<TimePoint> velocityWaitsSince_;

    std::size_t assertions_ = 0;
    wire::Velocity wanted_;
    std::optional<wire::Velocity> sent_;
    std::optional<wire::Velocity> answered_;
    TimePoint sentAt_{};
    TimePoint answeredAt_{};
    std::size_t openReplies_ = 0;   ///< So many Update Morales may still come.
    std::size_t strayReplies_ = 0;  ///< So many of them answer something before the last velocity.
    std::optional<int> morale_;
    std::optional<MutinyView> mutiny_;
    SideCounters counters_;
    std::uint64_t version_ = 0;
};

}  // namespace kickstand::coach
