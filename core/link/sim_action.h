#pragma once

#include <string>

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

/// The present value of an action's quantity.
struct SimReading {
    std::string action;
    int unit = -1;  ///< The robot or device; -1 where the action takes none.
    double value = 0;

    friend bool operator==(const SimReading&, const SimReading&) = default;
};

}  // namespace kickstand
