#pragma once

#include <memory>

#include "ui/gamepad/pad_source.h"

namespace kickstand::ui {

/// Gamepads and joysticks through SDL2, with its database of controllers. Must be made, used and ended on one
/// thread. SDL tells when a gamepad is plugged in or gone; of one that is out of reach it knows only what the
/// system's driver notices.
class SdlPads final : public PadSource {
  public:
    SdlPads();
    ~SdlPads() override;
    SdlPads(const SdlPads&) = delete;
    SdlPads& operator=(const SdlPads&) = delete;

    void update() override;
    std::vector<PadInfo> pads() const override;
    std::optional<PadState> state(int id) const override;

  private:
    class Pad;
    std::vector<std::unique_ptr<Pad>> pads_;
    bool works_ = false;
};

}  // namespace kickstand::ui
