#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/coach/radio_settings.h"
#include "core/coach/traffic.h"
#include "core/coach/types.h"
#include "core/link/byte_link.h"

namespace kickstand::coach {

/// Where the link stands.
enum class LinkState : std::uint8_t {
    Idle,
    Searching,  ///< Waits for the port to be there.
    Opening,    ///< The port.
    Asking,     ///< The radio module, whether it speaks in frames.
    NoModule,   ///< The port is open, and no module in API mode answers: it can be looked for.
    Setting,    ///< The module is looked for, read or set.
    Running,
    Failed,
};

/// What a session's quantities over time are (SignalId::signal); the unit is the other side's team.
enum class Signal : std::uint16_t { Morale, Rssi_dBm, Forward_percent, Turn_percent };

/// All there is to show of one COACH or TOWRP session at one moment.
struct Snapshot {
    TimePoint time{};
    LinkState link = LinkState::Idle;
    std::optional<Error> error;  ///< Why the link failed or waits.
    ByteLinkInfo port;
    std::optional<FoundRadio> radio;  ///< The module, as it was read last.
    Baud tries = 0;                   ///< While Setting: the speed that is tried.
    std::optional<wire::Role> role;   ///< What this program plays.
    CoachView coach;
    TowrpView towrp;
    std::vector<std::string> series;  ///< The actions that quell a mutiny, in their order.
    bool mustPassZero = true;         ///< Held inputs are refused until they have been at zero.
    TrafficCounters traffic;
    /// The newest packets, oldest first; never null, immutable.
    std::shared_ptr<const TrafficEntries> entries = std::make_shared<const TrafficEntries>();
    std::uint64_t connections = 0;  ///< How often the link has come to run.

    /// Whether a boat is told to move.
    bool active() const { return coach.state == CoachState::Paired && !coach.wanted.isZero(); }
};

}  // namespace kickstand::coach
