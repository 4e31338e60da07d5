#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "core/base/time.h"

namespace kickstand::thunderbots::sim {

/// The beam in front of the kicker, and the lock-out that keeps an autokick from firing twice at one ball: it
/// lasts from the shot until 250 ms after the beam has cleared (protocol 6.5).
class BreakBeam {
  public:
    /// Autokick holds off for this long after the beam has cleared (protocol 6.5).
    static constexpr Duration kLockOut = std::chrono::milliseconds(250);

    /// Puts a ball into the beam or takes it out.
    void setBall(bool ball, TimePoint now) {
        if (ball_ && !ball && lockedOut_) lockOutEnd_ = now + kLockOut;
        ball_ = ball;
    }
    bool ball() const { return ball_; }
    /// The light sensor's reading, without noise: the ball scatters the beam into it.
    std::uint16_t light_adc() const { return ball_ ? 640 : 90; }

    /// Begins the lock-out. The ball is in the beam.
    void lockOut() {
        lockedOut_ = true;
        lockOutEnd_.reset();
    }
    bool lockedOut(TimePoint now) const { return lockedOut_ && (!lockOutEnd_ || now < *lockOutEnd_); }
    /// When the lock-out will end, where that is known.
    std::optional<TimePoint> lockOutEnd() const { return lockOutEnd_; }
    /// As after power-up: the ball stays, the lock-out does not.
    void forgetLockOut() {
        lockedOut_ = false;
        lockOutEnd_.reset();
    }

  private:
    bool ball_ = false;
    bool lockedOut_ = false;
    std::optional<TimePoint> lockOutEnd_;
};

}  // namespace kickstand::thunderbots::sim
