#include "core/thunderbots/sim/radio_medium.h"

#include <algorithm>

namespace kickstand::thunderbots::sim {

TimePoint RadioMedium::arrival(wire::Direction direction, TimePoint sent) {
    if (weather_.delay <= Duration::zero()) return sent;
    TimePoint& last = lastArrival_[static_cast<std::size_t>(direction)];
    last = std::max(last, sent + fromSeconds(seconds(weather_.delay) * uniform()));
    return last;
}

}  // namespace kickstand::thunderbots::sim
