#include "core/base/sleep_clock.h"

#ifdef __linux__
#include <ctime>
#endif

namespace kickstand {

#ifdef __linux__
namespace {

Duration read(clockid_t clock) {
    timespec time{};
    if (clock_gettime(clock, &time) != 0) return {};
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

Duration timeAsleep() {
    return read(CLOCK_BOOTTIME) - read(CLOCK_MONOTONIC);
}
#else
Duration timeAsleep() {
    return {};
}
#endif

}  // namespace kickstand
