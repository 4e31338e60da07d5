#pragma once

#include <string>
#include <vector>

namespace kickstand::ui {

/// Everything that can be moved or pressed on a gamepad, as it stands now.
struct PadState {
    std::vector<double> axes;  ///< −1 to 1.
    std::vector<bool> buttons;

    friend bool operator==(const PadState&, const PadState&) = default;
};

/// A gamepad that is plugged in.
struct PadInfo {
    int id = 0;        ///< Never used again for another one while the program runs.
    std::string name;  ///< As the device calls itself.
    std::string
        model;  ///< The same for all of one kind, on every day: what is set for it is remembered by this.
    bool known = false;  ///< Its sticks and buttons are where a standard controller has them.

    friend bool operator==(const PadInfo&, const PadInfo&) = default;
};

/// One thing on a gamepad that can be moved or pressed.
struct PadInput {
    enum class Kind { None, Axis, Button };
    Kind kind = Kind::None;
    int index = 0;
    bool reversed = false;  ///< Of an axis: its negative end counts as forward, or as pressed.

    friend bool operator==(const PadInput&, const PadInput&) = default;
};

/// Where an input of this state stands: −1 to 1 of an axis, 0 or 1 of a button. 0 for what it does not have.
double valueOf(const PadState& state, const PadInput& input);

}  // namespace kickstand::ui
