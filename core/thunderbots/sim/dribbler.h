#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/thunderbots/sim/motor.h"

namespace kickstand::thunderbots::sim {

/// The dribbler: a motor that heats up as it runs and is switched off while its thermistor reads outside
/// 200-499 (protocol 6.4).
class Dribbler {
  public:
    /// Lets time pass. `duty` is the PWM duty cycle of the operational parameters, 0-255.
    void step(Duration span, bool on, std::uint8_t duty);
    /// Sets the temperature, °C.
    void setTemperature(double celsius) { temperature_C_ = celsius; }

    double temperature_C() const { return temperature_C_; }
    /// The thermistor's reading, without noise.
    std::uint16_t thermistor_adc() const;
    /// Whether it turned, or would have but for a duty of 0, in the last step.
    bool running() const { return running_; }
    const Motor& motor() const { return motor_; }

  private:
    static constexpr double kAmbient_C = 25;

    Motor motor_;
    double temperature_C_ = kAmbient_C;
    bool running_ = false;
};

}  // namespace kickstand::thunderbots::sim
