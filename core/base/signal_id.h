#pragma once

#include <compare>
#include <cstdint>

namespace kickstand {

/// Names one quantity over time: which robot (or device), and which of its quantities. The system gives the
/// numbers meaning.
struct SignalId {
    std::uint16_t unit = 0;
    std::uint16_t signal = 0;

    friend auto operator<=>(const SignalId&, const SignalId&) = default;
};

}  // namespace kickstand
