#pragma once

namespace kickstand::ui {

/// A gamepad that exists in SDL's memory alone, plugged in while it lives: for trying SdlPads without one. On
/// the thread of an SdlPads that outlives it.
class VirtualPad {
  public:
    static constexpr int kAxes = 6;
    static constexpr int kButtons = 15;
    static constexpr int kHats = 1;

    /// `standard`: a controller that SDL knows; else a joystick of which it knows nothing.
    explicit VirtualPad(bool standard);
    ~VirtualPad() { unplug(); }
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    bool works() const { return id_ >= 0; }
    void move(int axis, double to);
    void press(int button, bool down);
    void unplug();

  private:
    int id_ = -1;
};

}  // namespace kickstand::ui
