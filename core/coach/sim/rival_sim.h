#pragma once

#include <optional>

#include "core/coach/sim/simulated_side.h"
#include "core/coach/wire/velocity.h"

namespace kickstand::coach::sim {

/// A simulated COACH with a pirate at its helm: takes its own team's boat, or else any that is available,
/// drives it about, and quells mutinies after a moment. Shares nothing with the side that this program plays.
class RivalSim final : public SimulatedSide {
  public:
    RivalSim(Scheduler& scheduler, RadioMedium& medium, wire::Team team, std::uint8_t channel,
             std::uint16_t pan);

    wire::Team team() const { return wire::teamOf(address()); }
    std::optional<wire::Team> boat() const { return boat_; }
    std::optional<int> morale() const { return morale_; }

  private:
    void came(std::uint16_t source, const wire::Message& message) override;
    void wake() override;
    void loop(bool slot) override;
    void steer();

    std::optional<wire::Team> boat_;
    std::optional<wire::Team> asked_;
    int asks_ = 0;
    TimePoint askedAt_{};
    TimePoint repliedAt_{};
    TimePoint steeredAt_{};
    std::optional<TimePoint> mutinyAt_;
    TimePoint suppressedAt_{};
    std::optional<int> morale_;
    std::size_t course_ = 0;
};

}  // namespace kickstand::coach::sim
