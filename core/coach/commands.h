#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/coach/radio_settings.h"
#include "core/coach/types.h"

namespace kickstand::coach {

// What a person, a script or a panel may ask of a session. Plain values; each is answered once. All of them
// can be refused with NotConnected; those of a role with RadioNotReady where no radio module in API mode
// answers.

/// Plays the COACH of a team from now on: its startup begins. RadioNotSet where the radio's address is
/// another; RoleRunning while another role is played.
struct StartCoach {
    Team team = 0;
    wire::TeamColor color = wire::TeamColor::Red;
};

/// Plays the TOWRP of a team from now on. Refused as StartCoach.
struct StartTowrp {
    Team team = 0;
};

/// Plays nothing any more, at once; a boat that was paired stops by its own timer. Done as well where no role
/// is played.
struct EndRole {
    static constexpr bool kMovesNothing = true;
};

/// As the COACH: asks a boat that says it is available to obey. Answered when it was asked; events tell how
/// it went. RobotNotAlive where it is not heard; BadArgument unless not paired.
struct Pair {
    Team boat = 0;
};

/// As the COACH: steers. `held`: it comes from an input that is held in place; such a one must have been at
/// zero once since pairing or STOP, or it is refused with MustPassZero. NotPaired, OutOfRange, StopLatched.
struct Steer {
    wire::Velocity velocity;
    bool held = false;
};

/// As the COACH. NotPaired, StopLatched, QueueFull.
struct FreeDigital {};
/// As the COACH, −100 to 100 %. OutOfRange besides.
struct FreeAnalog {
    int percent = 0;
};

/// As the COACH: sends Suppress Mutiny, without the series of actions. NotPaired.
struct Suppress {};

/// As the COACH: does one action of the series. All of them in order suppress the mutiny; a wrong one begins
/// anew. NotPaired; BadArgument where there is no mutiny or no such action.
struct Act {
    std::size_t action = 0;
};

/// Names the actions of the series, in their order: one to eight, none empty. BadArgument.
struct SetSeries {
    static constexpr bool kMovesNothing = true;
    std::vector<std::string> actions;
};

/// As the COACH: gives the boat up. NotPaired.
struct Jettison {};

/// As the TOWRP: the crew's morale; −10 is a mutiny. NotPaired, OutOfRange, BadArgument during a mutiny.
struct SetMorale {
    static constexpr bool kMovesNothing = true;
    int morale = 0;
};

/// Looks for the radio module at every usual speed and in every mode. Answered when it has been found and
/// read, which can take some seconds. TimedOut; RoleRunning; RequestPending while this or the next runs.
struct FindRadio {
    static constexpr bool kMovesNothing = true;
};

/// Sets the radio module, makes it last, and reads it back. Answered when that is done. RadioNotReady before
/// it has been found; FindRadio's errors; BadArgument, OutOfRange, RadioDiffers.
struct ApplyRadio {
    static constexpr bool kMovesNothing = true;
    RadioSettings settings;
};

/// Any of them.
using Command = std::variant<StartCoach, StartTowrp, EndRole, Pair, Steer, FreeDigital, FreeAnalog, Suppress,
                             Act, SetSeries, Jettison, SetMorale, FindRadio, ApplyRadio>;

}  // namespace kickstand::coach
