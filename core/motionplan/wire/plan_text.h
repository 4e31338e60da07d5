#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/motionplan/wire/movement.h"

namespace kickstand::motionplan::wire {

/// How long a text of a plan may be, in bytes: far longer than the longest plan is.
inline constexpr std::size_t kMostPlanTextBytes = 65536;
/// How many steps a text may have; more fit into no plan, but an editor may hold them.
inline constexpr std::size_t kMostPlanSteps = 500;

/// "forward 25", "back 100", "turn left 84", "turn right back 30": centimetres and degrees. Any thread.
std::string toText(const Movement& movement);
/// "forward 25, turn left 84". Any thread.
std::string toText(std::span<const Movement> movements);

/// Reads movements as people write them: parted by commas, semicolons or lines; "#" begins a comment that
/// ends with its line. A distance may have its unit (cm or m), an angle too (deg or °), and case does not
/// matter. "turn left" is the right wheel forward, "turn left back" the left wheel backward, and so on
/// (protocol 5.1). Amounts are not checked against the tables: encodeMovement() does that. Errors: Malformed
/// with the word in `detail`, its place in `got` (from 0) and what was expected in `subject`; OutOfRange for
/// an amount below 1 or past 100000 (in `got`, or as it was written in `detail`), and for texts and plans
/// past all bounds. Any thread.
Result<std::vector<Movement>> parsePlanText(std::string_view text);

}  // namespace kickstand::motionplan::wire
