#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/smartdevice/snapshot.h"

namespace kickstand::smartdevice {

/// The host's heartbeats to one device: one every 200 ms, told apart by their number, and how long the
/// answers took.
class Heartbeat {
  public:
    static constexpr Duration kEvery = std::chrono::milliseconds(200);

    /// The number of the request to send now, where it is time for one.
    std::optional<std::uint8_t> due(TimePoint now);
    /// A request came back. False for one that was not outstanding.
    bool answered(std::uint8_t id, TimePoint now);
    /// The line begins anew: what is outstanding is forgotten.
    void restart(TimePoint now);
    /// Of the last answers; empty before there was one.
    std::optional<Latency> latency() const;

  private:
    static constexpr std::size_t kKept = 128;

    std::array<std::optional<TimePoint>, 256> outstanding_{};
    std::array<Duration, kKept> took_{};
    std::size_t count_ = 0;  ///< Of answers ever.
    std::uint8_t next_ = 0;
    TimePoint nextAt_{};
};

}  // namespace kickstand::smartdevice
