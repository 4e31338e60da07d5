#include "ui/gamepad/pad_reader.h"

namespace kickstand::ui {

namespace {

/// From here on a trigger counts as pressed.
constexpr double kPressed = 0.5;

}  // namespace

PadReader::PadReader() {
    awaitNeutral();
}

void PadReader::awaitNeutral() {
    awaitsNeutral_ = true;
    for (const PadAction action : kPadActions) {
        // What is down already is no press; STOP is one the first time it is seen.
        if (action != PadAction::Stop) down_[static_cast<std::size_t>(action)] = true;
    }
}

PadReading PadReader::read(const PadState& state, const PadMap& map, const StickCurve& curve, bool wheels) {
    PadReading reading;
    bool neutral = true;
    for (std::size_t i = 0; i < kPadActions.size(); ++i) {
        const PadAction action = kPadActions.at(i);
        const double value = valueOf(state, map.input(action));
        if (!isStick(action)) {
            const bool down = value > kPressed;
            reading.pressed.at(i) = down && !down_.at(i);
            down_.at(i) = down;
        } else if (isOfMode(action, wheels)) {
            reading.value.at(i) = shaped(value, curve);
            neutral = neutral && reading.value.at(i) == 0;
        }
    }
    if (neutral) awaitsNeutral_ = false;
    reading.awaitsNeutral = awaitsNeutral_;
    if (!awaitsNeutral_) return reading;
    const bool stop = reading.wasPressed(PadAction::Stop);
    reading.value.fill(0);
    reading.pressed.fill(false);
    reading.pressed[static_cast<std::size_t>(PadAction::Stop)] = stop;
    return reading;
}

}  // namespace kickstand::ui
