#include "core/smartdevice/heartbeat.h"

#include <algorithm>
#include <utility>

namespace kickstand::smartdevice {

std::optional<std::uint8_t> Heartbeat::due(TimePoint now) {
    if (now < nextAt_) return std::nullopt;
    nextAt_ = now + kEvery;
    const std::uint8_t id = next_++;
    outstanding_.at(id) = now;
    return id;
}

bool Heartbeat::answered(std::uint8_t id, TimePoint now) {
    const auto sent = std::exchange(outstanding_.at(id), std::nullopt);
    if (!sent) return false;
    took_.at(count_++ % kKept) = now - *sent;
    return true;
}

void Heartbeat::restart(TimePoint now) {
    outstanding_.fill(std::nullopt);
    nextAt_ = now;
}

std::optional<Latency> Heartbeat::latency() const {
    const std::size_t count = std::min(count_, kKept);
    if (count == 0) return std::nullopt;
    std::array<Duration, kKept> sorted = took_;
    std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
    return Latency{sorted.at(count / 2), sorted.at((count * 99) / 100)};
}

}  // namespace kickstand::smartdevice
