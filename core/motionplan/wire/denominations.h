#pragma once

#include <array>
#include <cstddef>

namespace kickstand::motionplan::wire {

/// How many distances the low five bits of a movement byte can name (protocol 5.2).
inline constexpr std::size_t kDenominationCount = 32;

/// The distance in centimetres that each of them names, from code 0 on: what
/// resources/motionplan/denominations.json says. Each stands once and none is zero (protocol 5.2).
extern const std::array<int, kDenominationCount> kDenominations_cm;

}  // namespace kickstand::motionplan::wire
