#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/base/bytes.h"

namespace kickstand {

/// How badly a line treats each byte that passes, in either direction.
struct ByteFaultOptions {
    double lose = 0;    ///< Probability, 0-1, that a byte is lost.
    double damage = 0;  ///< Probability, 0-1, that one of its bits flips.
    double insert = 0;  ///< Probability, 0-1, that a byte out of nowhere comes before it.
    std::uint32_t seed = 1;

    bool any() const { return lose > 0 || damage > 0 || insert > 0; }
    friend bool operator==(const ByteFaultOptions&, const ByteFaultOptions&) = default;
};

/// A line that damages what passes, the same way each time for the same seed.
class ByteFaults {
  public:
    explicit ByteFaults(ByteFaultOptions options) : options_(options), random_(options.seed) {}

    /// What comes out of the line for what went in.
    std::vector<std::uint8_t> pass(ByteView bytes);
    /// From now on; the sequence of chances goes on where it was.
    void setOptions(const ByteFaultOptions& options) { options_ = options; }
    const ByteFaultOptions& options() const { return options_; }

  private:
    bool happens(double probability);

    ByteFaultOptions options_;
    std::mt19937 random_;
};

}  // namespace kickstand
