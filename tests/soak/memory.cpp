#include "tests/soak/memory.h"

#include <algorithm>
#include <fstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

#include "core/telemetry/store.h"

namespace kickstand::soak {

double resident_MB() {
    std::ifstream statm("/proc/self/statm");
    double total = 0;
    double resident = 0;
    statm >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

std::optional<double> allocated_MB() {
#ifdef __GLIBC__
    const auto counts = mallinfo2();
    const std::size_t bytes = counts.uordblks + counts.hblkhd;
    if (bytes != 0) return static_cast<double>(bytes) / 1e6;
#endif
    return std::nullopt;
}

double rings_MB(const EngineSnapshot& snapshot) {
    double taken_MB = 0;
    for (const SessionSnapshot& session : snapshot.sessions) {
        for (const SignalId key : session.telemetry->keys()) {
            const TimeSeries& series = *session.telemetry->find(key);
            const double filled =
                static_cast<double>(series.total()) / static_cast<double>(series.capacity());
            taken_MB += static_cast<double>(series.bytes()) * std::min(1.0, filled) / 1e6;
        }
    }
    return taken_MB;
}

}  // namespace kickstand::soak
