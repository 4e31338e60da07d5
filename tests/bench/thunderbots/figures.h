#pragma once

#include <algorithm>
#include <cstdio>
#include <vector>

namespace kickstand::bench {

/// The value below which a part of the samples lies; `samples` is not empty.
inline double quantile(std::vector<double>& samples, double part) {
    const auto at = static_cast<std::size_t>(part * static_cast<double>(samples.size() - 1));
    std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(at), samples.end());
    return samples[at];
}

/// Prints a JSON member with the median, the 99th percentile and the worst of some samples.
inline void printFigures(const char* name, std::vector<double>& samples, const char* end) {
    std::printf("  \"%s\": {\"samples\": %zu, \"p50\": %.3f, \"p99\": %.3f, \"max\": %.3f}%s\n", name,
                samples.size(), quantile(samples, 0.5), quantile(samples, 0.99), quantile(samples, 1), end);
}

}  // namespace kickstand::bench
