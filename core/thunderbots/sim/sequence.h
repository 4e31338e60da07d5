#pragma once

#include <array>
#include <cstdint>

#include "core/thunderbots/wire/pipes.h"

namespace kickstand::thunderbots::sim {

/// The 6-bit sequence numbers of one side's one direction, a number a pipe (protocol 5.3): for the sender the
/// one of the message that is under way, for the receiver the one that it takes next.
class SequenceNumbers {
  public:
    std::uint8_t of(wire::Pipe pipe) const { return numbers_[static_cast<std::size_t>(pipe)]; }
    /// Goes on to the number after this one (protocol 5.3).
    void step(wire::Pipe pipe) {
        std::uint8_t& number = numbers_[static_cast<std::size_t>(pipe)];
        number = static_cast<std::uint8_t>((number + 1) & 0x3F);
    }
    void reset() { numbers_ = {}; }

  private:
    std::array<std::uint8_t, wire::kPipeCount> numbers_{};
};

}  // namespace kickstand::thunderbots::sim
