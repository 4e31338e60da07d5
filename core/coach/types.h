#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/time.h"
#include "core/coach/wire/address.h"
#include "core/coach/wire/message.h"
#include "core/coach/wire/velocity.h"

namespace kickstand::coach {

using wire::Team;

/// The shortest time from one packet of a side to its next (coach protocol 5).
inline constexpr Duration kPacketGap = std::chrono::milliseconds(200);
/// How long a mutiny lasts before the crew takes the boat (coach protocol 7).
inline constexpr Duration kMutinySpan = std::chrono::seconds(3);
/// After so long without an answer, or without a velocity, a side is not paired any more (coach protocol 6,
/// 7).
inline constexpr Duration kPairedSilence = std::chrono::seconds(5);
/// After so long without a velocity a boat stops by itself (coach protocol 7).
inline constexpr Duration kVelocitySpan = std::chrono::seconds(1);

/// The states of a COACH (coach protocol 6).
enum class CoachState : std::uint8_t {
    Off,        ///< This program plays no COACH.
    Startup,    ///< Asks its own team's boat.
    NotPaired,  ///< Hears which boats are available.
    Asserting,  ///< Not paired, and asks one of them.
    Paired,
};

/// The states of a TOWRP (coach protocol 7).
enum class TowrpState : std::uint8_t {
    Off,  ///< This program plays no TOWRP.
    NotPaired,
    Paired,
    Mutiny,  ///< Paired, and the crew mutinies.
};

/// The timers of both charts, as they are drawn.
enum class TimerKind : std::uint8_t {
    Startup,        ///< COACH: ends the startup.
    Assert,         ///< COACH: the next assertion of the startup.
    Result,         ///< COACH: the assertion is repeated.
    Velocity,       ///< COACH: the next velocity. TOWRP: the boat stops.
    MoraleReply,    ///< COACH: the velocity is repeated.
    SuppressReply,  ///< COACH: Suppress Mutiny is repeated.
    Silence,        ///< Both: not paired any more.
    Mutiny,         ///< Both: the crew takes the boat.
    Available,      ///< TOWRP: the next "I am available".
    MoraleStep,     ///< TOWRP: the morale may change again.
};

/// A timer that runs.
struct RunningTimer {
    TimerKind kind = TimerKind::Startup;
    TimePoint due{};
    Duration span{};

    friend bool operator==(const RunningTimer&, const RunningTimer&) = default;
};

/// A boat that was heard.
struct HeardBoat {
    Team team = 0;
    int rssi_dBm = 0;
    TimePoint heard{};
    std::uint64_t packets = 0;
    std::optional<Team> coach{};  ///< Whom it obeys, where that was heard last.

    friend bool operator==(const HeardBoat&, const HeardBoat&) = default;
};

/// A mutiny as the COACH knows it.
struct MutinyView {
    TimePoint since{};
    TimePoint until{};
    std::size_t done = 0;     ///< So many actions of the series are done.
    bool suppressed = false;  ///< Suppress Mutiny has been asked for.

    friend bool operator==(const MutinyView&, const MutinyView&) = default;
};

/// What a side has counted.
struct SideCounters {
    std::uint64_t sent = 0;
    std::uint64_t received = 0;    ///< Messages that were taken.
    std::uint64_t foreign = 0;     ///< From senders that it takes nothing from.
    std::uint64_t outOfPlace = 0;  ///< From the right sender, and not for this state.
    std::uint64_t resent = 0;

    friend bool operator==(const SideCounters&, const SideCounters&) = default;
};

/// All there is to show of a COACH.
struct CoachView {
    CoachState state = CoachState::Off;
    Team team = 0;
    wire::TeamColor color = wire::TeamColor::Red;
    std::optional<Team> boat{};      ///< Paired with it, or asked.
    std::vector<HeardBoat> boats{};  ///< By team.
    wire::Velocity wanted{};
    std::optional<wire::Velocity> sent{};  ///< The last one.
    /// The same, once an Update Morale has come after it, and until one is late.
    std::optional<wire::Velocity> answered{};
    TimePoint sentAt{};  ///< Before the first one: when they were paired.
    TimePoint answeredAt{};
    std::optional<int> morale{};
    std::optional<MutinyView> mutiny{};
    std::size_t waiting = 0;     ///< Packets that wait for a slot.
    std::size_t assertions = 0;  ///< Sent in this try.
    std::vector<RunningTimer> timers{};
    SideCounters counters{};
};

/// All there is to show of a TOWRP.
struct TowrpView {
    TowrpState state = TowrpState::Off;
    Team team = 0;
    std::optional<Team> coach{};  ///< Whom it obeys.
    wire::TeamColor color = wire::TeamColor::Red;
    wire::Velocity velocity{};  ///< What it does; zero when it has stopped by itself.
    TimePoint velocityAt{};
    bool stoppedItself = false;  ///< Paired, and no velocity has come for a second.
    int morale = 0;
    std::optional<int> moraleWanted{};  ///< Set by hand, and not yet due.
    std::uint64_t freeDigital = 0;      ///< How many came.
    std::optional<int> freeAnalog{};    ///< The last one, −100 to 100 %.
    std::vector<RunningTimer> timers{};
    SideCounters counters{};
};

}  // namespace kickstand::coach
