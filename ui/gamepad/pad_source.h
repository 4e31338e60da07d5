#pragma once

#include <optional>
#include <vector>

#include "ui/gamepad/pad_state.h"

namespace kickstand::ui {

/// Where gamepads come from. One thread, whichever it is; nothing of it waits.
class PadSource {
  public:
    virtual ~PadSource() = default;

    /// Looks at all gamepads: what the others tell is of the last time.
    virtual void update() = 0;
    virtual std::vector<PadInfo> pads() const = 0;
    /// None for one that is gone. One that has fallen asleep without saying so still has its last state: a
    /// stick that is held still and a silent gamepad look the same.
    virtual std::optional<PadState> state(int id) const = 0;
};

}  // namespace kickstand::ui
