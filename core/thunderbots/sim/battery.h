#pragma once

#include "core/base/time.h"

namespace kickstand::thunderbots::sim {

/// A robot's battery on the bench (protocol 6.2): it gives way under load and locks the robot out when it is
/// low for long. It does not run down by itself, so that a day of traffic leaves the robots as they were.
class Battery {
  public:
    /// `rest_V` is the voltage with the robot idle.
    explicit Battery(double rest_V) : rest_V_(rest_V), terminal_V_(rest_V) {}

    /// Changes the voltage at rest, volts.
    void setRest(double rest_V);
    double rest_V() const { return rest_V_; }
    /// Lets time pass with a load, in amperes above that of an idle robot.
    void step(Duration span, double load_A);
    /// What the robot measures.
    double terminal_V() const { return terminal_V_; }
    /// Whether it was below 13.0 V for a second. Stays so until switched off.
    bool lockedOut() const { return lockedOut_; }
    /// Takes the load off and forgets the lock-out.
    void switchOff();

  private:
    double rest_V_;
    double terminal_V_;
    double load_A_ = 0;
    Duration low_{};
    bool lockedOut_ = false;
};

}  // namespace kickstand::thunderbots::sim
