#include "tests/soak/memory.h"

#include <algorithm>
#include <fstream>

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
