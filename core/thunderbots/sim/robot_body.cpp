#include "core/thunderbots/sim/robot_body.h"

#include <cmath>

namespace kickstand::thunderbots::sim {
namespace {

constexpr double kCharger_A = 2.9;
constexpr double kDribbler_A = 1.8;
// Friction grows with the speed, torque with how far the wheel lags behind.
constexpr double kFriction_AperUnit = 0.004;
constexpr double kTorque_AperUnit = 0.01;

constexpr std::size_t kDribblerTarget = 5;

}  // namespace

void RobotBody::step(Duration span, const BodyInputs& inputs) {
    double load_A = 0;
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        const double target = inputs.wheels[i];
        const bool driven = inputs.run && (deadWheels >> i & 1) == 0;
        wheels[i].step(span, target, driven);
        if (!driven) continue;
        const double speed = wheels[i].speed();
        load_A += kFriction_AperUnit * std::abs(speed) + kTorque_AperUnit * std::abs(target - speed);
    }
    dribbler.step(span, inputs.dribble, inputs.dribblerDuty);
    if (dribbler.running()) load_A += kDribbler_A * inputs.dribblerDuty / 255;
    capacitor.step(span, inputs.charge && !chargerBroken);
    if (capacitor.charging()) load_A += kCharger_A;
    battery.step(span, load_A);
}

std::uint8_t testLeds(wire::TestMode mode, const RobotBody& body) {
    const wire::TestTargets targets = wire::targetsOf(mode.testClass);
    if (targets.any() && (mode.target < targets.first || mode.target > targets.last)) return 0;
    const std::size_t target = mode.target;
    switch (mode.testClass) {
        case wire::TestClass::None:
            return 0;
        case wire::TestClass::Lamp:
            return 0b1111;
        case wire::TestClass::Hall:
            return target == kDribblerTarget ? body.dribbler.motor().hallLines()
                                             : body.wheels[target - 1].hallLines();
        case wire::TestClass::Encoder:
            return body.wheels[target - 1].encoderLines();
        case wire::TestClass::EncoderCount:
            return static_cast<std::uint8_t>(body.wheels[target - 1].count() & 0b1111);
        case wire::TestClass::Charger:
            return static_cast<std::uint8_t>((body.capacitor.chargePulses() & 1) |
                                             (body.capacitor.timedOut() ? 0b10 : 0));
    }
    return 0;
}

}  // namespace kickstand::thunderbots::sim
