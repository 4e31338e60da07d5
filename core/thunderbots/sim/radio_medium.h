#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "core/base/time.h"
#include "core/thunderbots/wire/pipes.h"

namespace kickstand::thunderbots::sim {

/// How badly the radio treats what is sent.
struct RadioWeather {
    double loss = 0;         ///< Probability that a frame, or the acknowledgement of one, is lost.
    double duplication = 0;  ///< Probability that a frame arrives twice.
    Duration delay{};        ///< Each frame arrives up to that much later. None overtakes another.
};

/// The air between dongle and robots: decides the fate of every frame by a generator of its own, so that a
/// seed and an order of events always give the same fates.
class RadioMedium {
  public:
    RadioMedium(RadioWeather weather, std::uint64_t seed) : weather_(weather), random_(seed) {}

    const RadioWeather& weather() const { return weather_; }
    void setWeather(const RadioWeather& weather) { weather_ = weather; }

    /// Whether something is lost.
    bool lost() { return happens(weather_.loss); }
    /// How often a frame arrives: 0, 1 or 2 times.
    int copies() {
        if (lost()) return 0;
        return happens(weather_.duplication) ? 2 : 1;
    }
    /// When what is sent at `sent` arrives.
    TimePoint arrival(wire::Direction direction, TimePoint sent);

  private:
    /// 0 to below 1. By hand: the distributions of the standard library differ between its implementations.
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    bool happens(double probability) { return probability > 0 && uniform() < probability; }

    RadioWeather weather_;
    std::mt19937_64 random_;
    std::array<TimePoint, 2> lastArrival_{};
};

}  // namespace kickstand::thunderbots::sim
