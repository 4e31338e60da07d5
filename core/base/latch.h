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
    PanelClosed,     ///< The panel that drives was closed while something moved.
    Suspend,         ///< The machine goes to sleep.
};

/// STOP: once set it stays set until a person re-arms. Checked at every submission to a link. All of it may
/// be called from any thread, and setting it never waits.
class StopLatch {
  public:
    /// Sets the latch. The first reason stays until re-armed. True when it was not set before.
    bool set(StopReason reason) {
        ++presses_;
        std::uint64_t before = state_.load();
        const auto bits = static_cast<std::uint64_t>(reason);
        do {
            if ((before & kReason) != 0) return false;
        } while (!state_.compare_exchange_weak(
            before, ((before >> kCountAt) + 1) << kCountAt | bits << kLastAt | bits));
        return true;
    }
    /// Whether everything is to stand still now.
    bool isSet() const { return reason() != StopReason::None; }
    /// Why; None while it is not set.
    StopReason reason() const { return static_cast<StopReason>(state_.load() & kReason); }
    /// How often it has been set, and why the last time: a STOP that was re-armed before anybody came to look
    /// still shows here.
    std::uint64_t stops() const { return state_.load() >> kCountAt; }
    StopReason lastReason() const { return static_cast<StopReason>(state_.load() >> kLastAt & kReason); }
    /// How often anybody asked for it, while it was set too: whoever presses STOP again wants it sent again.
    std::uint64_t presses() const { return presses_.load(); }
    /// Re-arms: a separate act of a person, never of the program.
    void rearm() { state_.fetch_and(~kReason); }

  private:
    // One word, so that the reason, the one before it and the count never contradict each other.
    static constexpr std::uint64_t kReason = 0xFF;
    static constexpr int kLastAt = 8;
    static constexpr int kCountAt = 16;
    std::atomic<std::uint64_t> state_{0};
    std::atomic<std::uint64_t> presses_{0};
};

}  // namespace kickstand
