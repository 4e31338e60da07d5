#pragma once

#include <array>

#include "ui/gamepad/pad_map.h"
#include "ui/gamepad/stick_curve.h"

namespace kickstand::ui {

/// What a gamepad asks for at one moment.
struct PadReading {
    bool awaitsNeutral = false;  ///< Sticks must be let go before anything but STOP counts.
    std::array<double, kPadActions.size()>
        value{};  ///< −1 to 1 of each stick, shaped; 0 while it is awaited.
    std::array<bool, kPadActions.size()>
        pressed{};  ///< Buttons that have gone down since the last reading; while it is awaited only STOP.

    double of(PadAction action) const { return value[static_cast<std::size_t>(action)]; }
    bool wasPressed(PadAction action) const { return pressed[static_cast<std::size_t>(action)]; }
};

/// Turns a gamepad's states into what it asks for. What was held from before counts for nothing until it has
/// been let go once; only STOP counts always. Pure.
class PadReader {
  public:
    PadReader();

    /// From here on everything must be let go before it counts: a new gamepad, STOP, another choice.
    void awaitNeutral();
    /// `wheels`: it drives the wheels of each side, and not the body.
    PadReading read(const PadState& state, const PadMap& map, const StickCurve& curve, bool wheels);

  private:
    bool awaitsNeutral_ = true;
    std::array<bool, kPadActions.size()> down_{};
};

/// Whether an action is one of the way of driving.
constexpr bool isOfMode(PadAction action, bool wheels) {
    const bool ofWheels = action == PadAction::LeftWheels || action == PadAction::RightWheels;
    return !isStick(action) || ofWheels == wheels;
}

}  // namespace kickstand::ui
