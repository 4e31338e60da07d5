#pragma once

#include <QString>
#include <array>

#include "ui/gamepad/pad_state.h"

namespace kickstand::ui {

/// What a gamepad can do here. The sticks first, then the buttons.
enum class PadAction { Forward, Left, Turn, LeftWheels, RightWheels, Dribbler, Kick, Chip, Stop };
inline constexpr std::array kPadActions{PadAction::Forward,    PadAction::Left,        PadAction::Turn,
                                        PadAction::LeftWheels, PadAction::RightWheels, PadAction::Dribbler,
                                        PadAction::Kick,       PadAction::Chip,        PadAction::Stop};
constexpr bool isStick(PadAction action) {
    return action <= PadAction::RightWheels;
}

/// Which stick or button does what.
class PadMap {
  public:
    /// As a standard controller has it.
    PadMap();

    const PadInput& input(PadAction action) const { return inputs_[static_cast<std::size_t>(action)]; }
    /// A button does one thing: whoever had this one before has none then. The one that STOP has stays
    /// STOP's.
    void setInput(PadAction action, const PadInput& input);

    /// For settings: "a1- a0- …".
    QString toText() const;
    /// Takes what toText() made; anything else leaves the map as it is. Tells whether it was taken.
    bool setText(const QString& text);

    friend bool operator==(const PadMap&, const PadMap&) = default;

  private:
    std::array<PadInput, kPadActions.size()> inputs_;
};

/// What an input is called: "left stick up", "button 3".
QString inputText(const PadInput& input, bool knownPad);
QString actionText(PadAction action);

}  // namespace kickstand::ui
