#pragma once

#include <optional>

#include "ui/gamepad/pad_state.h"

namespace kickstand::ui {

/// Finds out which stick or button a person moves: the first that goes far from where it rested.
class PadLearner {
  public:
    /// `stick`: only an axis will do; else an axis does as well as a button, for triggers.
    PadLearner(PadState rest, bool stick) : rest_(std::move(rest)), stick_(stick) {}

    /// What has been moved, as soon as something has.
    std::optional<PadInput> look(const PadState& state) const;

  private:
    PadState rest_;
    bool stick_;
};

}  // namespace kickstand::ui
