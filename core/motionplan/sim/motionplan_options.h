#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace kickstand::motionplan::sim {

/// What happens by chance to messages between host and robot.
struct Weather {
    double loss = 0;       ///< Part of the messages that never arrive, in either direction.
    double replyLoss = 0;  ///< Part of the reads that the NXT never answers.
    double duplicate = 0;  ///< Part of what the robot puts out that it puts out twice.
    Duration delay{};      ///< By which what the robot puts out comes later.
};

/// How a simulated NXT is. The defaults are one whose messages all arrive.
struct NxtOptions {
    Weather weather;
    std::uint64_t seed = 1;  ///< Of all that happens by chance.
    double pace = 1;         ///< How much faster than real it moves.
    bool text = false;       ///< Its program reads mailboxes as text: what follows a zero is lost.
};

/// The options of `sim:motionplan`: `loss=0.1`, `reply-loss=0.1`, `duplicate=0.1`, `delay_ms=50`, `seed=1`,
/// `pace=4`, `text=on|off`. Errors: UnknownName for another option, OutOfRange with the bounds, BadArgument
/// with what was given. Any thread.
Result<NxtOptions> parseNxtOptions(const std::map<std::string, std::string>& options);

/// OutOfRange for a value that was given; bounds that are not whole stand in `detail`. Any thread.
Error outOfBounds(std::string_view name, double lowest, double highest, std::string_view given);

}  // namespace kickstand::motionplan::sim
