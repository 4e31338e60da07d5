#pragma once

#include <cstdint>

#include "core/base/time.h"

namespace kickstand::thunderbots::sim {

/// The kicker's capacitor bank, its charger and the solenoids that empty it (protocol 6.3). The charger moves
/// the same energy with every pulse, so the voltage rises ever more slowly: 0 to 219 V in 3.5 s.
class Capacitor {
  public:
    /// Where the charger stops; it starts again a little below.
    static constexpr double kFull_V = 219.0;
    static constexpr double kRestart_V = 217.5;

    /// Lets time pass with the charger switched on or off. What was charged stays for minutes after.
    void step(Duration span, bool chargerOn);
    /// Connects the solenoids for `on` altogether and keeps the charger off for `busy`, after which it begins
    /// a new charge.
    void discharge(Duration on, Duration busy);
    /// Sets the voltage, volts.
    void set(double volts) { volts_ = volts; }

    double volts() const { return volts_; }
    /// Above 215 V.
    bool charged() const;
    /// Whether the charger draws power now.
    bool charging() const { return charging_; }
    /// Whether a charge took longer than 8 s; the charger then rests until it is switched off and on.
    bool timedOut() const { return timedOut_; }
    /// Pulses that the charger has given, ten a second while it charges.
    std::uint32_t chargePulses() const;

  private:
    void charge(Duration span);
    void leak(Duration span);

    double volts_ = 0;
    bool charging_ = false;
    bool timedOut_ = false;
    Duration pause_{};
    Duration cycle_{};
    Duration total_{};
};

}  // namespace kickstand::thunderbots::sim
