#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/motionplan/wire/fields.h"
#include "core/motionplan/wire/movement.h"

namespace kickstand::motionplan {

using wire::Movement;
using wire::Wheels;

/// Where a plan is to go, which says how long it may be (protocol 4.1, 4.9).
enum class PlanUse : std::uint8_t { Slot, Trigger };

/// How many movements fit. Any thread.
constexpr int mostMovements(PlanUse use) {
    return use == PlanUse::Slot ? wire::kMostMovements : wire::kMostTriggerMovements;
}

/// The bytes of a plan's movements. Errors: OutOfRange ("number of movements") where there are none or too
/// many; NoMovementCode for the first that has no code: its place in `got` (from 0), itself in `subject`, and
/// in `detail` what can be written in its place. Any thread.
Result<std::vector<std::uint8_t>> planBytes(std::span<const Movement> movements, PlanUse use);

/// What Create sends for a plan, or Update, and which of its bytes, counted from 0, are zero: a robot whose
/// program reads its mailbox as text loses what follows the first of them (protocol 5.3).
struct SentPlan {
    std::vector<std::uint8_t> bytes;
    std::vector<std::size_t> zeros;
};
/// Errors: as planBytes(); OutOfRange for another plan or slot. Any thread.
Result<SentPlan> sentPlan(bool update, int plan, int slot, std::span<const Movement> movements);

/// The movements that bytes mean; those that mean nothing are left out. Any thread.
std::vector<Movement> movementsOf(std::span<const std::uint8_t> bytes);

/// What may stand in the place of a movement without a code, as text: "forward 35, forward 3", or "turn left
/// 84 or turn left 87" where nothing is exact; empty where it has a code. Any thread.
std::string alternativeTo(const Movement& movement);

}  // namespace kickstand::motionplan
