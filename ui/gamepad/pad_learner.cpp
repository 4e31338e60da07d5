#include "ui/gamepad/pad_learner.h"

#include <algorithm>
#include <cmath>

namespace kickstand::ui {

namespace {

/// A stick that is only touched moves less.
constexpr double kFar = 0.6;

}  // namespace

std::optional<PadInput> PadLearner::look(const PadState& state) const {
    const std::size_t axes = std::min(state.axes.size(), rest_.axes.size());
    for (std::size_t i = 0; i < axes; ++i) {
        const double moved = state.axes[i] - rest_.axes[i];
        if (std::abs(moved) >= kFar) return PadInput{PadInput::Kind::Axis, static_cast<int>(i), moved < 0};
    }
    if (stick_) return std::nullopt;
    for (std::size_t i = 0; i < state.buttons.size(); ++i) {
        const bool rested = i < rest_.buttons.size() && rest_.buttons[i];
        if (state.buttons[i] && !rested) return PadInput{PadInput::Kind::Button, static_cast<int>(i), false};
    }
    return std::nullopt;
}

}  // namespace kickstand::ui
