#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/smartdevice/sim/body.h"

namespace kickstand::smartdevice::sim {
namespace {

using wire::ValueType;

// Where the parameters of a PolarBear stand.
enum Place : int {
    Duty,
    PositionSet,
    PositionKp,
    PositionKi,
    PositionKd,
    VelocitySet,
    VelocityKp,
    VelocityKi,
    VelocityKd,
    CurrentLimit,
    Position,
    Velocity,
    Current,
    Deadband,
    Places,
};

constexpr double kTicksPerTurn = 4400;
constexpr double kFastest = 9000;  ///< Ticks a second at full duty without load.
constexpr double kSpinUp_s = 0.25;
constexpr double kStall_A = 9;     ///< At full duty and standing still.
constexpr double kHardware_A = 7;  ///< The limit of the hardware itself.
constexpr double kStep_s = 0.002;

enum class Mode : std::uint8_t { Duty, Position, Velocity };

/// A motor with an encoder behind a PolarBear: spins up against its inertia, draws current as it does, and is
/// held back at the current threshold.
class MotorBody final : public Body {
  public:
    MotorBody() { reset(); }

    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters = [] {
            std::vector<SimParameter> all(Places, SimParameter{ValueType::Float, false, true});
            all[Duty].readable = all[Position].readable = all[Deadband].readable = true;
            all[Velocity] = all[Current] = {ValueType::Float, true, false};
            return all;
        }();
        return kParameters;
    }

    wire::Value read(int parameter) const override {
        return static_cast<float>(held_.at(static_cast<std::size_t>(parameter)));
    }

    bool write(int parameter, const wire::Value& value) override {
        const double number = wire::toNumber(value).value_or(NAN);
        if (!std::isfinite(number)) return false;
        auto& place = held_.at(static_cast<std::size_t>(parameter));
        place = number;
        if (parameter == Duty || parameter == Deadband)
            place = std::clamp(number, parameter == Duty ? -1.0 : 0.0, 1.0);
        if (parameter == Duty) mode_ = Mode::Duty;
        if (parameter == PositionSet) mode_ = Mode::Position;
        if (parameter == VelocitySet) mode_ = Mode::Velocity;
        if (parameter == PositionSet || parameter == VelocitySet) integral_ = lastError_ = 0;
        // A float cannot hold every double; what is told is what is held.
        place = static_cast<float>(place);
        return true;
    }

    void disable() override {
        mode_ = Mode::Duty;
        held_[Duty] = 0;
        held_[VelocitySet] = 0;
    }

    void reset() override {
        const double position = held_[Position];
        held_.fill(0);
        held_[PositionKp] = held_[VelocityKp] = 1;
        held_[CurrentLimit] = kHardware_A;
        held_[Position] = position;
        mode_ = Mode::Duty;
        if (supply_ != nullptr) supply_->drawn_A -= std::exchange(told_A_, 0);
    }

    bool wantsHeartbeats() const override { return true; }

    void advance(double span_s) override {
        const auto steps = static_cast<int>(span_s / kStep_s);
        for (int i = 0; i < steps; ++i)
            step(kStep_s);
        if (const double rest_s = span_s - steps * kStep_s; rest_s > 0) step(rest_s);
    }

    void connectTo(Supply& supply) override { supply_ = &supply; }

    std::vector<SimQuantity> quantities() const override { return {{"load", "1", 0, 1}}; }
    std::optional<double> quantity(std::string_view name) const override {
        if (name != "load") return std::nullopt;
        return load_;
    }
    void setQuantity(std::string_view name, double value) override {
        if (name == "load") load_ = value;
    }

  private:
    double controlled(double error, int kp, double span_s) {
        const auto at = static_cast<std::size_t>(kp);
        integral_ = std::clamp(integral_ + error * span_s, -1.0, 1.0);
        const double slope = span_s > 0 ? (error - lastError_) / span_s : 0;
        lastError_ = error;
        return std::clamp(held_[at] * error + held_[at + 1] * integral_ + held_[at + 2] * slope, -1.0, 1.0);
    }

    void step(double span_s) {
        if (mode_ == Mode::Position)
            held_[Duty] =
                controlled((held_[PositionSet] - held_[Position]) / kTicksPerTurn, PositionKp, span_s);
        if (mode_ == Mode::Velocity)
            held_[Duty] =
                controlled((held_[VelocitySet] - held_[Velocity]) / kFastest * 3, VelocityKp, span_s);
        double duty = std::abs(held_[Duty]) < held_[Deadband] ? 0 : held_[Duty];
        const double speed = held_[Velocity] / kFastest;
        // The current goes with what the motor's own voltage leaves of the duty cycle.
        const double limit = std::clamp(held_[CurrentLimit], 0.0, kHardware_A) / kStall_A;
        const double drawn = std::clamp(duty - speed, -limit, limit);
        const double pull = load_ * (speed > 0 ? 1 : speed < 0 ? -1 : 0);
        held_[Velocity] += (drawn - pull * 0.5) * kFastest * span_s / kSpinUp_s;
        if (duty == 0 && std::abs(held_[Velocity]) < kFastest * 0.001) held_[Velocity] = 0;
        held_[Position] += held_[Velocity] * span_s;
        held_[Current] = std::abs(drawn) * kStall_A;
        if (supply_ != nullptr) supply_->drawn_A += held_[Current] - std::exchange(told_A_, held_[Current]);
    }

    std::array<double, Places> held_{};
    Mode mode_ = Mode::Duty;
    double load_ = 0;
    double integral_ = 0;
    double lastError_ = 0;
    Supply* supply_ = nullptr;
    double told_A_ = 0;  ///< Of the supply's sum.
};

}  // namespace

std::unique_ptr<Body> makeMotorBody() {
    return std::make_unique<MotorBody>();
}

}  // namespace kickstand::smartdevice::sim
