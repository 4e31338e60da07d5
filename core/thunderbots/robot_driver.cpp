#include "core/thunderbots/robot_driver.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace kickstand::thunderbots {
namespace {

constexpr double kRamp_per_s = 200;

/// One wheel's next position: at once to anything nearer to zero, through zero on a change of sign, and from
/// there outwards no faster than the ramp.
double follow(double from, double target, double step) {
    if (from * target < 0) from = 0;
    if (std::abs(target) <= std::abs(from)) return target;
    return std::clamp(target, from - step, from + step);
}

}  // namespace

void RobotDriver::halt() {
    intent_ = RobotIntent{};
    exact_.fill(0);
}

Result<void> RobotDriver::setWheels(const WheelSpeeds& wheels, bool held, int limit, TimePoint now) {
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        if (std::abs(wheels[i]) <= limit) continue;
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = "wheel" + std::to_string(i + 1);
        error.lowest = -limit;
        error.highest = limit;
        error.got = wheels[i];
        if (held) refuseHeld();
        return fail(std::move(error));
    }
    const bool atZero = std::all_of(wheels.begin(), wheels.end(), [](int speed) { return speed == 0; });
    if (held && atZero) intent_.mustPassZero = false;
    if (held && intent_.mustPassZero) return fail(Errc::MustPassZero, "wheels");
    if (!intent_.run) {
        exact_.fill(0);
        intent_.commanded.fill(0);
    }
    // Time spent at a steady speed is no credit for the ramp to the next one.
    if (!ramping()) advancedAt_ = now;
    intent_.run = true;
    intent_.target = wheels;
    return {};
}

bool RobotDriver::clampTo(int limit) {
    bool changed = false;
    for (int& speed : intent_.target) {
        const int clamped = std::clamp(speed, -limit, limit);
        changed = changed || clamped != speed;
        speed = clamped;
    }
    return changed;
}

void RobotDriver::brake() {
    intent_.run = false;
    intent_.target.fill(0);
    intent_.commanded.fill(0);
    exact_.fill(0);
}

void RobotDriver::armHighVoltage(bool armed) {
    intent_.highVoltageArmed = armed;
    if (armed) return;
    intent_.charger = false;
    intent_.discharging = false;
    intent_.sweeping = false;
    setAutokick(false, {});
}

void RobotDriver::setAutokick(bool armed, const wire::KickTimes& times) {
    intent_.autokick = armed;
    intent_.autokickTimes = armed ? times : wire::KickTimes{};
}

void RobotDriver::setDischarging(bool discharging) {
    intent_.discharging = discharging;
    if (!discharging) return;
    intent_.charger = false;
    setAutokick(false, {});
}

void RobotDriver::setSweeping(bool sweeping) {
    intent_.sweeping = sweeping;
    if (sweeping) setAutokick(false, {});
}

void RobotDriver::setChecking(bool checking) {
    const bool armed = intent_.highVoltageArmed;
    halt();
    intent_.highVoltageArmed = armed;
    intent_.checking = checking;
}

void RobotDriver::advance(TimePoint now, bool ramped) {
    const double step = kRamp_per_s * seconds(now - advancedAt_);
    advancedAt_ = now;
    if (!intent_.run) return;
    for (std::size_t i = 0; i < exact_.size(); ++i) {
        exact_[i] = ramped ? follow(exact_[i], intent_.target[i], step) : intent_.target[i];
        intent_.commanded[i] = static_cast<int>(std::trunc(exact_[i]));
    }
}

wire::DriveBlock RobotDriver::block() const {
    wire::DriveBlock block;
    block.run = intent_.run;
    block.charge = intent_.charger;
    block.dribble = intent_.dribbler;
    block.autokickArmed = intent_.autokick;
    block.autokick = intent_.autokickTimes;
    if (intent_.run) {
        for (std::size_t i = 0; i < block.wheels.size(); ++i)
            block.wheels[i] = static_cast<std::int16_t>(intent_.commanded[i]);
    }
    block.testClass = static_cast<std::uint8_t>(intent_.driveTestMode.testClass);
    block.testTarget = intent_.driveTestMode.target;
    return block;
}

}  // namespace kickstand::thunderbots
