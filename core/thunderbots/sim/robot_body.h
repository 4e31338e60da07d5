#pragma once

#include <array>
#include <cstdint>

#include "core/thunderbots/sim/battery.h"
#include "core/thunderbots/sim/capacitor.h"
#include "core/thunderbots/sim/dribbler.h"
#include "core/thunderbots/sim/motor.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/test_mode.h"

namespace kickstand::thunderbots::sim {

/// What the robot's electronics ask of its mechanics; the default is everything off and braked.
struct BodyInputs {
    bool run = false;
    bool charge = false;
    bool dribble = false;
    std::array<std::int16_t, wire::kWheelCount> wheels{};
    std::uint8_t dribblerDuty = 0;
};

/// A robot's mechanics and power: what has a voltage, a speed or a temperature. Knows no clock: it is told
/// how much time passes.
struct RobotBody {
    explicit RobotBody(double battery_V) : battery(battery_V) {}

    /// Lets time pass with constant inputs. Each part follows its own exact curve; only the battery's load is
    /// taken as constant over the span.
    void step(Duration span, const BodyInputs& inputs);

    std::uint8_t deadWheels = 0;  ///< Bit n: wheel n + 1 does not turn, whatever is asked of it.
    bool chargerBroken = false;   ///< It draws nothing and gives nothing.
    Battery battery;
    Capacitor capacitor;
    std::array<Motor, wire::kWheelCount> wheels;
    Dribbler dribbler;
};

/// What the four LEDs show in a test mode, bit n for LED n (protocol 4.2). A target that its class does not
/// have shows nothing.
std::uint8_t testLeds(wire::TestMode mode, const RobotBody& body);

}  // namespace kickstand::thunderbots::sim
