#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/motionplan/wire/movement.h"

namespace kickstand::motionplan {

// What a person, a script or a panel may ask of a session. Plain values; each is answered once, when the
// robot has confirmed it or the station has given up (protocol 6).
//
// All of them can be refused with NotConnected; by the robot with PlanRefused (its error code in `got`) and
// before that with WouldBeRefused; and end with TimedOut (nothing comes back), EchoDiffers (something else
// comes back), Unconfirmed, NxtRefused (the NXT's own status) or Disconnected. While STOP is latched all but
// QuerySlot, ReadTrigger and StopPlan are refused with StopLatched. QueueFull where too much waits.

/// Puts a plan into an empty slot (protocol 4.1). Its slot is asked for first where it is not known.
/// OutOfRange, NoMovementCode: planBytes().
struct CreatePlan {
    static constexpr bool kMovesNothing = true;
    int plan = 1;  ///< 1-254.
    int slot = 0;  ///< 0-4.
    std::vector<wire::Movement> movements;
};

/// Replaces the plan of a slot, which has to have this ID (protocol 4.3).
struct UpdatePlan {
    static constexpr bool kMovesNothing = true;
    int plan = 1;
    int slot = 0;
    std::vector<wire::Movement> movements;
};

/// Starts the plan of a slot (protocol 4.4). Sent once and never again: Unconfirmed where neither an echo nor
/// a status says that it came, and a person has to look.
struct ExecutePlan {
    int plan = 1;
    int slot = 0;
};

/// Stops what executes (protocol 4.2), before everything that waits: that ends with Cancelled.
struct StopPlan {
    static constexpr bool kMovesNothing = true;
};

/// Asks which plan is in a slot (protocol 4.6).
struct QuerySlot {
    static constexpr bool kMovesNothing = true;
    int slot = 0;
};

/// Changes the speed of wheels while a plan executes (protocol 4.7). Sent once and never again, as
/// ExecutePlan.
struct AdjustSpeed {
    wire::Wheels wheels = wire::Wheels::BothForward;
    int change_percent = 0;  ///< -100 to 100.
};

/// Sets the plan that the robot starts when its connection is lost (protocol 4.9).
struct SetTrigger {
    static constexpr bool kMovesNothing = true;
    int plan = 1;
    std::vector<wire::Movement> movements;
};

/// Asks which trigger plan there is (protocol 4.9).
struct ReadTrigger {
    static constexpr bool kMovesNothing = true;
};

/// Any of them.
using Command = std::variant<CreatePlan, UpdatePlan, ExecutePlan, StopPlan, QuerySlot, AdjustSpeed,
                             SetTrigger, ReadTrigger>;

}  // namespace kickstand::motionplan
