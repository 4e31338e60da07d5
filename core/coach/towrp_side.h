#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/coach/deadlines.h"
#include "core/coach/packet_slots.h"
#include "core/coach/side.h"

namespace kickstand::coach {

/// The TOWRP of a team, the boat: its states, timers and its queue (coach protocol 5, 7). Knows no radio:
/// what it sends goes to its output, what came is told to it. The scheduler's thread.
class TowrpSide {
  public:
    TowrpSide(Scheduler& scheduler, SideOutput output);
    TowrpSide(const TowrpSide&) = delete;
    TowrpSide& operator=(const TowrpSide&) = delete;

    /// Wakes: not paired, morale zero.
    void begin(Team team);
    /// Ends; nothing is sent any more.
    void end(Unpairing why);
    /// The radio has been opened: its first slot is a packet's gap from now.
    void linkOpened() { slots_.rest(); }
    /// A message came.
    void received(const Received& message);

    /// Changes the crew's morale, −10 to 127: now, or as soon as the last change is a second old. −10 is a
    /// mutiny. Errors: NotPaired; OutOfRange; BadArgument during a mutiny.
    Result<void> setMorale(int morale);

    /// STOP: the boat stands still until released, whatever comes.
    void halt();
    void release() { halted_ = false; }

    TowrpState state() const { return state_; }
    bool moves() const { return !velocity_.isZero(); }
    /// Rises whenever view() would give something else.
    std::uint64_t version() const { return version_; }
    TowrpView view() const;

  private:
    bool isPaired() const { return state_ == TowrpState::Paired || state_ == TowrpState::Mutiny; }
    void expired(TimerKind kind);
    bool sendNext();
    void send(std::uint16_t destination, wire::Opcode opcode, std::uint8_t parameter);
    std::uint16_t coachAddress() const { return wire::addressOf(wire::Role::Coach, *coach_); }
    void obey(const Received& message);
    void velocityCame(std::uint8_t parameter);
    void suppressCame();
    void applyMorale(int morale);
    void beginMutiny();
    void sleep();
    void unpair(Unpairing why);
    void tell(EventKind kind, int team, std::int64_t code = 0);

    Scheduler& scheduler_;
    SideOutput output_;
    Deadlines deadlines_;
    PacketSlots slots_;
    TowrpState state_ = TowrpState::Off;
    Team team_ = 0;
    std::optional<Team> coach_;
    wire::TeamColor color_ = wire::TeamColor::Red;
    bool halted_ = false;

    // What waits for a slot, most urgent first.
    bool resultWaits_ = false;
    bool moraleWaits_ = false;
    std::optional<TimePoint> mutinySince_;  ///< Since when Mutiny in Progress has waited.
    bool availableWaits_ = false;

    wire::Velocity velocity_;
    TimePoint velocityAt_{};
    bool stoppedItself_ = false;
    int morale_ = 0;
    std::optional<int> moraleWanted_;
    std::uint64_t freeDigital_ = 0;
    std::optional<int> freeAnalog_;
    SideCounters counters_;
    std::uint64_t version_ = 0;
};

}  // namespace kickstand::coach
