#pragma once

#include <atomic>
#include <cstdint>

namespace kickstand {

/// Why everything was stopped.
enum class StopReason : std::uint8_t {
    None,
    Person,          ///< The STOP button, its key, or the stop command.
    EmergencyStop,   ///< The e-stop switch left "run".
    RobotLost,       ///< A robot vanished while something moved, charged or was armed.
    LinkLost,        ///< The dongle or cable vanished.
    FocusLost,       ///< The window lost the keyboard while something moved.
    HeartbeatStale,  ///< The window, or the command that drives, stopped responding while something moved.
    Suspend,         ///< The machine goes to sleep.
};

/// STOP: once set it stays set until a person re-arms. Checked at every submission to a link. All of it may
/// be called from any thread, and setting it never waits.
class StopLatch {
  public:
    /// Sets the latch. The first reason stays until re-armed. True when it was not set before.
    bool set(StopReason reason) {
        StopReason expected = StopReason::None;
        return reason_.compare_exchange_strong(expected, reason);
    }
    bool isSet() const { return reason_.load() != StopReason::None; }
    StopReason reason() const { return reason_.load(); }
    /// Re-arms: a separate act of a person, never of the program.
    void rearm() { reason_.store(StopReason::None); }

  private:
    std::atomic<StopReason> reason_{StopReason::None};
};

}  // namespace kickstand
