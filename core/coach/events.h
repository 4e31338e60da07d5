#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace kickstand::coach {

/// What can happen. The comment says what Event's numbers mean for it; `team` is the other side's.
enum class EventKind : std::uint8_t {
    Connected,     ///< The line is open and its radio module answers. code: its address.
    NoModule,      ///< The line is open, and no radio module in API mode answers.
    Disconnected,  ///< Closed on purpose.
    LinkLost,
    LinkFailed,    ///< code: the Errc; text: its detail.
    Waiting,       ///< The port is not there; it is waited for.
    CoachStarted,  ///< team: our own.
    TowrpStarted,  ///< team: our own.
    RoleEnded,
    BoatFound,      ///< A boat said that it is available for the first time.
    PairingFailed,  ///< code: the Errc why; previous: the COACH that has it.
    Paired,
    Unpaired,  ///< code: an Unpairing.
    MutinyStarted,
    MutinyQuelled,  ///< code: the morale now.
    MutinyLost,     ///< Its time is over.
    SuppressSent,
    Jettisoned,
    FreeDigital,  ///< Sent, or come.
    FreeAnalog,   ///< The same. code: percent.
    MoraleSet,    ///< code: the morale.
    BoatStopped,  ///< As a TOWRP: no velocity for a second.
    Stopped,      ///< Zero velocity has been sent for STOP.
    RadioFound,   ///< code: bits per second; text: how it speaks.
    RadioNotFound,
    RadioApplied,  ///< code: its address; previous: how many settings changed.
    RadioFailed,   ///< code: the Errc; text: what the module refused.
    ModuleReset,   ///< The radio module has started anew.
};

/// Why a side is not paired any more.
enum class Unpairing : std::uint8_t { Silence, Jettison, Mutiny, RoleEnded, LinkLost };

/// One thing that happened, with its facts. Text for people is made in core/engine/describe.h.
struct Event {
    EventKind kind = EventKind::Connected;
    TimePoint time{};
    int team = -1;  ///< -1 where it concerns none.
    std::int64_t code = 0;
    std::int64_t previous = 0;
    std::string text{};
};

/// "mutiny-started", …: stable names for JSON. Any thread.
std::string_view name(EventKind kind);
/// "silence", …: the same. Any thread.
std::string_view name(Unpairing why);

}  // namespace kickstand::coach
