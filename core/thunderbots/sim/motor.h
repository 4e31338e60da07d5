#pragma once

#include <cstdint>

#include "core/base/time.h"

namespace kickstand::thunderbots::sim {

/// One brushless motor with its sensors: it follows its set point like a first-order system, brakes more
/// quickly, and counts quarter-degrees (protocol 6.6). Speeds are those of the wire, quarter-degrees per
/// 5 ms.
class Motor {
  public:
    /// Lets time pass towards `target`, driven by it or braking.
    void step(Duration span, double target, bool driven);

    double speed() const { return speed_; }
    /// Quarter-degrees turned altogether, as an encoder counts them.
    std::int64_t count() const;
    /// The two encoder lines, bit 0 and 1: a quadrature pair.
    std::uint8_t encoderLines() const;
    /// The three Hall sensors, bits 0-2: never all alike.
    std::uint8_t hallLines() const;

  private:
    double speed_ = 0;
    double position_ = 0;
};

}  // namespace kickstand::thunderbots::sim
