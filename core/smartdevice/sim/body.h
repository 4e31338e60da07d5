#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/smartdevice/wire/value.h"

namespace kickstand::smartdevice::sim {

/// A parameter as the firmware of a board has it.
struct SimParameter {
    wire::ValueType type;
    bool readable;
    bool writable;
};

/// A quantity of a body that a hand can set: "battery" in V.
struct SimQuantity {
    const char* name;
    const char* unit;
    double lowest;
    double highest;
};

/// What the boards of one robot draw from its battery.
struct Supply {
    double drawn_A = 0;
};

/// What is on a board beside the protocol: its sensors and motors. Time passes as it is told. The simulator's
/// thread.
class Body {
  public:
    virtual ~Body() = default;

    virtual const std::vector<SimParameter>& parameters() const = 0;
    /// The present value of a parameter that can be read.
    virtual wire::Value read(int parameter) const = 0;
    /// Takes a value of the parameter's type, perhaps only a part of it; false where it does not.
    virtual bool write(int parameter, const wire::Value& value) = 0;
    /// Stops all that moves.
    virtual void disable() {}
    /// As after power came.
    virtual void reset() {}
    virtual void advance(double /*span_s*/) {}
    /// Whether the board disables itself when its heartbeat requests are not answered.
    virtual bool wantsHeartbeats() const { return false; }

    /// Shares a battery with the robot's other boards. Once, before time passes; it must outlive the body.
    virtual void connectTo(Supply& /*supply*/) {}

    virtual std::vector<SimQuantity> quantities() const { return {}; }
    virtual std::optional<double> quantity(std::string_view /*name*/) const { return std::nullopt; }
    virtual void setQuantity(std::string_view /*name*/, double /*value*/) {}
};

/// A kind of board that can be simulated.
struct BodyKind {
    const char* name;  ///< As the catalogue has it; "Unknown" for one that no catalogue has.
    std::uint8_t id;
    std::unique_ptr<Body> (*make)();
};
/// All of them. Any thread.
const std::vector<BodyKind>& bodyKinds();

/// Each in its file.
std::unique_ptr<Body> makeMotorBody();
std::unique_ptr<Body> makeBatteryBody();
std::unique_ptr<Body> makeLimitSwitchBody();
std::unique_ptr<Body> makeLineFollowerBody();
std::unique_ptr<Body> makePotentiometerBody();
std::unique_ptr<Body> makeEncoderBody();
std::unique_ptr<Body> makeTeamFlagBody();
std::unique_ptr<Body> makeServoBody();
std::unique_ptr<Body> makeRfidBody();
std::unique_ptr<Body> makeUnknownBody();

}  // namespace kickstand::smartdevice::sim
