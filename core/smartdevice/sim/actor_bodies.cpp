#include <algorithm>
#include <array>
#include <cmath>

#include "core/smartdevice/sim/body.h"

namespace kickstand::smartdevice::sim {
namespace {

using wire::ValueType;

class TeamFlagBody final : public Body {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters(7, SimParameter{ValueType::Bool, true, true});
        return kParameters;
    }
    wire::Value read(int parameter) const override { return lit_.at(static_cast<std::size_t>(parameter)); }
    bool write(int parameter, const wire::Value& value) override {
        lit_.at(static_cast<std::size_t>(parameter)) = std::get<bool>(value);
        return true;
    }
    void disable() override { lit_.fill(false); }
    void reset() override { lit_.fill(false); }

  private:
    std::array<bool, 7> lit_{};
};

class ServoBody final : public Body {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters(2, SimParameter{ValueType::Float, true, true});
        return kParameters;
    }
    wire::Value read(int parameter) const override { return held_.at(static_cast<std::size_t>(parameter)); }
    bool write(int parameter, const wire::Value& value) override {
        const float number = std::get<float>(value);
        if (!std::isfinite(number)) return false;
        // Further than its stops a servo does not go.
        held_.at(static_cast<std::size_t>(parameter)) = std::clamp(number, -1.0F, 1.0F);
        return true;
    }
    void reset() override { held_.fill(0); }

  private:
    std::array<float, 2> held_{};
};

/// Of a kind that no catalogue has: three parameters of different widths, the last of which can be written.
class UnknownBody final : public Body {
  public:
    const std::vector<SimParameter>& parameters() const override {
        static const std::vector<SimParameter> kParameters{{ValueType::Uint8, true, false},
                                                           {ValueType::Uint32, true, false},
                                                           {ValueType::Uint16, true, true}};
        return kParameters;
    }
    wire::Value read(int parameter) const override {
        if (parameter == 0) return std::uint8_t{7};
        if (parameter == 1) return static_cast<std::uint32_t>(time_s_ * 1000);
        return held_;
    }
    bool write(int /*parameter*/, const wire::Value& value) override {
        held_ = std::get<std::uint16_t>(value);
        return true;
    }
    void advance(double span_s) override { time_s_ += span_s; }

  private:
    double time_s_ = 0;
    std::uint16_t held_ = 0x1234;
};

}  // namespace

std::unique_ptr<Body> makeTeamFlagBody() {
    return std::make_unique<TeamFlagBody>();
}
std::unique_ptr<Body> makeServoBody() {
    return std::make_unique<ServoBody>();
}
std::unique_ptr<Body> makeUnknownBody() {
    return std::make_unique<UnknownBody>();
}

const std::vector<BodyKind>& bodyKinds() {
    static const std::vector<BodyKind> kKinds{{"LimitSwitch", 0x00, makeLimitSwitchBody},
                                              {"LineFollower", 0x01, makeLineFollowerBody},
                                              {"Potentiometer", 0x02, makePotentiometerBody},
                                              {"Encoder", 0x03, makeEncoderBody},
                                              {"BatteryBuzzer", 0x04, makeBatteryBody},
                                              {"TeamFlag", 0x05, makeTeamFlagBody},
                                              {"ServoControl", 0x07, makeServoBody},
                                              {"YogiBear", 0x0A, makeMotorBody},
                                              {"RFID", 0x0B, makeRfidBody},
                                              {"PolarBear", 0x0C, makeMotorBody},
                                              {"Unknown", 0x42, makeUnknownBody}};
    return kKinds;
}

}  // namespace kickstand::smartdevice::sim
