#pragma once

#include <optional>

#include "core/coach/sim/simulated_side.h"
#include "core/coach/wire/velocity.h"

namespace kickstand::coach::sim {

/// How a simulated boat's crew is.
struct CrewOptions {
    /// Its morale falls by one this often while it is paired; never where it is zero.
    Duration fall = std::chrono::seconds(5);
};

/// A simulated boat, written from the protocol's text alone: it shares nothing with the side that this
/// program plays.
class TowrpSim final : public SimulatedSide {
  public:
    TowrpSim(Scheduler& scheduler, RadioMedium& medium, wire::Team team, std::uint8_t channel,
             std::uint16_t pan, CrewOptions crew);

    wire::Team team() const { return wire::teamOf(address()); }
    std::optional<wire::Team> coach() const { return coach_; }
    wire::Velocity velocity() const { return velocity_; }
    int morale() const { return morale_; }
    bool mutinies() const { return mutinyAt_.has_value(); }
    std::uint64_t velocities() const { return velocities_; }
    std::uint64_t freeDigital() const { return freeDigital_; }
    std::optional<int> freeAnalog() const { return freeAnalog_; }
    /// Sets the morale; −10 is a mutiny. Only while it is paired.
    void setMorale(int morale);

  private:
    void came(std::uint16_t source, const wire::Message& message) override;
    void wake() override;
    void loop(bool slot) override;
    void obey(const wire::Message& message);
    void timers();

    const CrewOptions crew_;
    std::optional<wire::Team> coach_;
    wire::Velocity velocity_;
    TimePoint velocityAt_{};
    TimePoint availableAt_{};
    TimePoint moraleAt_{};
    std::optional<TimePoint> mutinyAt_;
    TimePoint mutinyToldAt_{};
    int morale_ = 0;
    bool result_ = false;
    bool reply_ = false;
    std::uint64_t velocities_ = 0;
    std::uint64_t freeDigital_ = 0;
    std::optional<int> freeAnalog_;
};

}  // namespace kickstand::coach::sim
