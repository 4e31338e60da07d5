#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/session_host.h"
#include "core/engine/link_provider.h"
#include "core/engine/systems.h"
#include "core/link/link_uri.h"
#include "core/link/sim_action.h"

namespace kickstand {

class TelemetryStore;

/// Identifies a session from connect() until it is closed. Zero is never given out.
using SessionId = std::uint32_t;

/// Opens a session on a link. Answered when the link has been made (not yet when it runs: the snapshot
/// tells). Errors: BadUri, Unsupported.
struct Connect {
    LinkUri uri;
};

/// Brakes, closes and forgets a session.
struct Disconnect {};

/// Does something to a simulated system from outside the wire. Errors: Unsupported on hardware; SimControl's.
struct SimPerform {
    std::string action;
    int unit = -1;
    double value = 0;
};

/// Looks for hardware again; the snapshot's `found` and `ports` are what there was.
struct Discover {};

/// All that can be asked of the engine, as plain values.
using CommandBody = std::variant<Connect, Disconnect, SimPerform, Discover, SystemCommand>;

/// A command on its way in: answered once, under its id.
struct Command {
    CommandId id = 0;
    SessionId session = 0;
    CommandBody body;
};

/// The one answer to a command.
struct Answer {
    CommandId id = 0;
    SessionId session = 0;
    Result<void> result;
};

/// What happened to the engine itself.
struct EngineNote {
    enum class Kind : std::uint8_t { Stopped, Rearmed, AnswersLost, SessionOpened, SessionClosed };

    Kind kind = Kind::Stopped;
    TimePoint time{};
    StopReason reason = StopReason::None;
    std::uint64_t count = 0;
    std::string text;  ///< SessionOpened: the URI.
};

/// An event with the session it belongs to (0: the engine's own).
struct EngineEvent {
    SessionId session = 0;
    std::variant<EngineNote, SystemEvent> body;
};

/// One session in a snapshot.
struct SessionSnapshot {
    SessionId id = 0;
    LinkUri uri;
    std::vector<SimAction> simActions;    ///< Empty for hardware.
    std::vector<int> simUnits;            ///< The units that actions can be done to.
    std::vector<SimReading> simReadings;  ///< What the actions' quantities are now, ten times a second.
    SystemSnapshot system;
    std::shared_ptr<const TelemetryStore> telemetry;
};

/// The latest state of everything, immutable once published.
struct EngineSnapshot {
    TimePoint time{};
    StopReason stop = StopReason::None;
    bool heartbeatFresh = false;
    bool discovered = false;  ///< Whether `found` has been filled since the engine started.
    std::vector<FoundDevice> found;
    std::vector<BytePort> ports;  ///< The serial ports there were then.
    std::vector<SessionSnapshot> sessions;
};

}  // namespace kickstand
