#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/link/byte_link.h"
#include "core/motionplan/wire/fields.h"

namespace kickstand::motionplan {

/// How the serial line to the robot stands.
enum class LinkState : std::uint8_t { Idle, Searching, Opening, Running, Failed };

/// What is known of one slot.
struct SlotState {
    bool known = false;
    int plan = wire::kNoPlan;  ///< 0: it is empty.
    TimePoint at{};            ///< When that was known.
    /// The movements' bytes, where this connection has put them there.
    std::vector<std::uint8_t> movements{};
};

/// What is known of the trigger plan: the one that starts when the connection is lost.
struct TriggerState {
    bool known = false;
    int plan = wire::kNoPlan;  ///< Not known and yet a plan: that one was sent, and may be there.
    TimePoint at{};
    std::vector<std::uint8_t> movements{};
};

/// Whether and what the robot executes, as far as it has said.
struct Execution {
    enum class State : std::uint8_t {
        Idle,    ///< Nothing, or nothing was heard of it.
        Asked,   ///< Execute was sent; not confirmed yet.
        Runs,    ///< The robot says so.
        Unsure,  ///< Execute was sent and nothing came back: it may have begun.
    };
    State state = State::Idle;
    int plan = 0;
    int slot = 0;
    int step = 0;         ///< From 1; 0 before the first status.
    TimePoint stepAt{};   ///< When that step was first heard of.
    TimePoint heardAt{};  ///< The last status.
    bool stale = false;   ///< No status for longer than the robot should be silent.
    /// The bytes of what executes, where they are known.
    std::vector<std::uint8_t> movements{};

    bool active() const { return state != State::Idle; }
};

/// How the last Stop of this connection stands.
enum class StopState : std::uint8_t {
    None,      ///< None was sent.
    UnderWay,  ///< Sent, and not confirmed yet.
    Confirmed,
    Unconfirmed,  ///< Sent as often as it is, and nothing came back.
};

/// The request under way.
struct RequestState {
    wire::MessageKind kind = wire::MessageKind::Stop;
    bool readsTrigger = false;  ///< Not a message but a look at the trigger plan.
    int attempt = 0;            ///< How often it was sent.
    TimePoint since{};
    std::size_t waiting = 0;  ///< More behind it.
};

/// How much passed, and how much of it was damaged, since the session began.
struct TrafficCounters {
    std::uint64_t telegramsOut = 0;
    std::uint64_t telegramsIn = 0;
    std::uint64_t skipped = 0;     ///< Bytes that belong to no telegram.
    std::uint64_t malformed = 0;   ///< Telegrams and messages that make no sense.
    std::uint64_t timeouts = 0;    ///< Reads that nobody answered.
    std::uint64_t resends = 0;     ///< Messages sent again.
    std::uint64_t unexpected = 0;  ///< Echoes and answers that nobody waited for: late ones, duplicates.
};

/// All there is to show of one motion-plan session at one moment.
struct Snapshot {
    TimePoint time{};
    LinkState link = LinkState::Idle;
    std::optional<Error> error;  ///< Why the link failed or waits.
    ByteLinkInfo port;
    bool answers = false;           ///< Whether the NXT answers what is read of it.
    std::uint8_t nxtStatus = 0x40;  ///< The last status it gave.
    std::array<SlotState, wire::kSlots> slotStates;
    TriggerState trigger;
    Execution execution;
    std::optional<RequestState> request;
    StopState stop = StopState::None;
    TimePoint stopConfirmedAt{};  ///< When the robot last confirmed a Stop; zero for never.
    /// The connection is gone, and the robot may be moving where no STOP reaches it.
    bool outOfReach = false;
    TrafficCounters traffic;
    std::uint64_t connections = 0;  ///< How often the link has come to run.

    /// Whether anything executes, or may.
    bool active() const { return execution.active(); }
};

}  // namespace kickstand::motionplan
