#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/link/sim_action.h"

namespace kickstand {

/// What a simulator lets a person do to it from outside the wire. Plain names and numbers, so that one panel,
/// one command and one control socket serve every system. Called on the simulator's thread.
class SimControl {
  public:
    virtual ~SimControl() = default;
    /// Every action there is.
    virtual std::vector<SimAction> actions() const = 0;
    /// The numbers of the robots or devices that actions with a unit can be done to.
    virtual std::vector<int> units() const { return {}; }
    /// Does one. `unit` is the robot or device where the action takes one, -1 for all of them.
    /// Errors: UnknownName, OutOfRange (with the bounds), BadArgument for a unit that is not there.
    virtual Result<void> perform(std::string_view action, int unit, double value) = 0;
    /// The present value of an action's quantity; empty where it has none or the unit is not there.
    virtual std::optional<double> value(std::string_view action, int unit) const = 0;
};

}  // namespace kickstand
