#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kickstand {

/// One thing that can be done to a simulated system by hand: "put the ball into robot 3's beam".
struct SimAction {
    std::string name;      ///< "ball", "battery", "dead", "e-stop", "loss", "unplug", …
    bool perUnit = false;  ///< Whether it takes a robot's (device's) number.
    std::string unit;      ///< The unit of the value: "V", "probability", "0 or 1".
    double lowest = 0;
    double highest = 1;

    friend bool operator==(const SimAction&, const SimAction&) = default;
};

/// What a simulator lets a person do to it from outside the wire. Plain names and numbers, so that one panel,
/// one command and one control socket serve every system. Called on the simulator's thread.
class SimControl {
  public:
    virtual ~SimControl() = default;
    /// Every action there is.
    virtual std::vector<SimAction> actions() const = 0;
    /// Does one. `unit` is the robot or device where the action takes one, -1 for all of them.
    /// Errors: UnknownName, OutOfRange (with the bounds), BadArgument for a unit that is not there.
    virtual Result<void> perform(std::string_view action, int unit, double value) = 0;
    /// The present value of an action's quantity; empty where it has none or the unit is not there.
    virtual std::optional<double> value(std::string_view action, int unit) const = 0;
};

}  // namespace kickstand
