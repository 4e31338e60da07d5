#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace kickstand::motionplan::wire {

/// Which wheels a movement turns, and which way: the top three bits of its byte (protocol 5.1). Six and seven
/// do not exist.
enum class Wheels : std::uint8_t {
    BothForward,
    BothBack,
    LeftForward,
    LeftBack,
    RightForward,
    RightBack,
};
inline constexpr int kWheelsCount = 6;

/// "both-forward", …: stable names. Any thread.
const char* name(Wheels wheels) noexcept;
/// Whether the movement is a turn about one standing wheel rather than a straight line. Any thread.
constexpr bool isTurn(Wheels wheels) noexcept {
    return wheels >= Wheels::LeftForward;
}
/// Whether these wheels go backward. Any thread.
constexpr bool isBack(Wheels wheels) noexcept {
    return (static_cast<unsigned>(wheels) & 1U) != 0;
}
/// Whether the robot's nose turns to the left: the right wheel forward or the left one back. Any thread.
constexpr bool turnsLeft(Wheels wheels) noexcept {
    return wheels == Wheels::RightForward || wheels == Wheels::LeftBack;
}

/// One step of a plan.
struct Movement {
    Wheels wheels = Wheels::BothForward;
    int amount = 0;  ///< Both wheels: centimetres, a distance of the table. One wheel: degrees.

    friend bool operator==(const Movement&, const Movement&) = default;
};

/// A turn is a multiple of this, from one step to 30 of them (protocol 5.1).
inline constexpr int kAngleStep_deg = 3;
inline constexpr int kLargestAngle_deg = 90;

/// The byte of a movement (protocol 5). Errors: NoEncoding, with the amount in `got`, for a distance that the
/// table does not have or an angle that is no multiple of 3 from 3 to 90. Any thread.
Result<std::uint8_t> encodeMovement(const Movement& movement);

/// What a byte means; none for wheel codes 6 and 7, and for a turn by 0 or 31 steps (protocol 5). Any thread.
std::optional<Movement> decodeMovement(std::uint8_t byte) noexcept;

/// The movements of that kind that add up to exactly `amount`, as few as there are, the largest first.
/// Errors: OutOfRange outside 1 to what `most` movements can reach; NoEncoding for an angle that is no
/// multiple of 3, with the nearest ones in `lowest` and `highest`. Any thread.
Result<std::vector<Movement>> exactSum(Wheels wheels, int amount, int most);

}  // namespace kickstand::motionplan::wire
