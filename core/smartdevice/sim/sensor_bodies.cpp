#include <algorithm>
#include <array>
#include <cmath>

#include "core/smartdevice/sim/body.h"

namespace kickstand::smartdevice::sim {
namespace {

using wire::ValueType;

constexpr SimParameter kSensed{ValueType::Float, true, false};
constexpr SimParameter kSensedBool{ValueType::Bool, true, false};

/// A body whose parameters cannot be written.
class Sensor : public Body {
  public:
    bool write(int /*parameter*/, const wire::Value& /*value*/) override { return false; }
};

class LimitSwitchBody final : public Sensor {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters(3, kSensedBool);
        return kParameters;
    }
    wire::Value read(int parameter) const override { return (pressed_ >> parameter & 1) != 0; }
    std::vector<SimQuantity> quantities() const override { return {{"switches", "bits", 0, 7}}; }
    std::optional<double> quantity(std::string_view /*name*/) const override { return pressed_; }
    void setQuantity(std::string_view /*name*/, double value) override { pressed_ = static_cast<int>(value); }

  private:
    int pressed_ = 0;
};

/// Over a tape that wanders from side to side.
class LineFollowerBody final : public Sensor {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters(3, kSensed);
        return kParameters;
    }
    wire::Value read(int parameter) const override {
        constexpr double kApart = 0.8;
        constexpr double kDark = 0.08;
        const double off = (parameter - 1) * kApart - tape_;
        return static_cast<float>(kDark + (0.95 - kDark) * std::exp(-off * off * 4));
    }
    void advance(double span_s) override {
        if (held_) return;
        time_s_ += span_s;
        tape_ = 0.7 * std::sin(time_s_ * 0.8);
    }
    std::vector<SimQuantity> quantities() const override { return {{"tape", "1", -1, 1}}; }
    std::optional<double> quantity(std::string_view /*name*/) const override { return tape_; }
    void setQuantity(std::string_view /*name*/, double value) override {
        tape_ = value;
        held_ = true;
    }

  private:
    double time_s_ = 0;
    double tape_ = 0;
    bool held_ = false;
};

class PotentiometerBody final : public Sensor {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters(3, kSensed);
        return kParameters;
    }
    wire::Value read(int parameter) const override {
        return static_cast<float>(dials_.at(static_cast<std::size_t>(parameter)));
    }
    std::vector<SimQuantity> quantities() const override {
        return {{"dial0", "1", 0, 1}, {"dial1", "1", 0, 1}, {"dial2", "1", 0, 1}};
    }
    std::optional<double> quantity(std::string_view name) const override {
        return dials_.at(static_cast<std::size_t>(name.back() - '0'));
    }
    void setQuantity(std::string_view name, double value) override {
        dials_.at(static_cast<std::size_t>(name.back() - '0')) = value;
    }

  private:
    std::array<double, 3> dials_{0.25, 0.5, 0.75};
};

class EncoderBody final : public Sensor {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters{kSensed};
        return kParameters;
    }
    wire::Value read(int /*parameter*/) const override { return static_cast<float>(std::round(position_)); }
    void advance(double span_s) override { position_ += speed_ * span_s; }
    std::vector<SimQuantity> quantities() const override { return {{"speed", "ticks/s", -20000, 20000}}; }
    std::optional<double> quantity(std::string_view /*name*/) const override { return speed_; }
    void setQuantity(std::string_view /*name*/, double value) override { speed_ = value; }

  private:
    double position_ = 0;
    double speed_ = 220;
};

/// Three cells that empty as current is drawn, and not quite together. Under load they sag, and recover after
/// it.
class BatteryBody final : public Sensor {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters{kSensedBool, kSensedBool, kSensed, kSensed,
                                                           kSensed,     kSensed,     kSensed, kSensed};
        return kParameters;
    }
    wire::Value read(int parameter) const override {
        const auto [first, second, third] = cells();
        switch (parameter) {
            case 0:
                return isUnsafe();
            case 1:
                return true;
            case 2:
                return static_cast<float>(first);
            case 3:
                return static_cast<float>(first + second);
            case 6:
                return static_cast<float>(second);
            case 7:
                return static_cast<float>(third);
            default:
                return static_cast<float>(first + second + third);
        }
    }
    void advance(double span_s) override {
        const double emptied_V = span_s * (kOwn_A + drawn_A()) * kPerAmpereSecond_V;
        battery_V_ = std::max(kEmpty_V, battery_V_ - emptied_V);
    }
    void connectTo(Supply& supply) override { supply_ = &supply; }
    std::vector<SimQuantity> quantities() const override {
        return {{"battery", "V", kEmpty_V, 12.6}, {"imbalance", "V", 0, 1}, {"current", "A", 0, 30}};
    }
    std::optional<double> quantity(std::string_view name) const override {
        if (name == "current") return current_A_;
        return name == "battery" ? battery_V_ : imbalance_V_;
    }
    void setQuantity(std::string_view name, double value) override {
        double& held = name == "current" ? current_A_ : name == "battery" ? battery_V_ : imbalance_V_;
        held = value;
    }

  private:
    static constexpr double kEmpty_V = 9;
    static constexpr double kResistance_Ohm = 0.05;
    /// What the boards and the radio take, whatever moves.
    static constexpr double kOwn_A = 1.5;
    /// Three ampere-hours from full to empty.
    static constexpr double kPerAmpereSecond_V = 3.6 / (3 * 3600);

    double drawn_A() const { return current_A_ + (supply_ == nullptr ? 0 : supply_->drawn_A); }
    double terminals_V() const { return battery_V_ - drawn_A() * kResistance_Ohm; }
    std::array<double, 3> cells() const {
        const double each = terminals_V() / 3;
        return {each + imbalance_V_ / 2, each, each - imbalance_V_ / 2};
    }
    bool isUnsafe() const {
        constexpr double kLowest_V = 10.5;
        constexpr double kMostImbalance_V = 0.3;
        return terminals_V() < kLowest_V || imbalance_V_ > kMostImbalance_V;
    }

    double battery_V_ = 11.8;  ///< With nothing drawn.
    double imbalance_V_ = 0.03;
    double current_A_ = 0;  ///< Beside what the motors draw.
    Supply* supply_ = nullptr;
};

class RfidBody final : public Sensor {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters{{ValueType::Uint32, true, false}, kSensedBool};
        return kParameters;
    }
    wire::Value read(int parameter) const override {
        if (parameter == 1) return tag_ != 0;
        return tag_;
    }
    std::vector<SimQuantity> quantities() const override { return {{"tag", "number", 0, 4294967295.0}}; }
    std::optional<double> quantity(std::string_view /*name*/) const override { return tag_; }
    void setQuantity(std::string_view /*name*/, double value) override {
        tag_ = static_cast<std::uint32_t>(value);
    }

  private:
    std::uint32_t tag_ = 0;
};

}  // namespace

std::unique_ptr<Body> makeLimitSwitchBody() {
    return std::make_unique<LimitSwitchBody>();
}
std::unique_ptr<Body> makeLineFollowerBody() {
    return std::make_unique<LineFollowerBody>();
}
std::unique_ptr<Body> makePotentiometerBody() {
    return std::make_unique<PotentiometerBody>();
}
std::unique_ptr<Body> makeEncoderBody() {
    return std::make_unique<EncoderBody>();
}
std::unique_ptr<Body> makeBatteryBody() {
    return std::make_unique<BatteryBody>();
}
std::unique_ptr<Body> makeRfidBody() {
    return std::make_unique<RfidBody>();
}

}  // namespace kickstand::smartdevice::sim
