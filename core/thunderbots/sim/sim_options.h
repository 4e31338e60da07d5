#pragma once

#include <cstdint>
#include <optional>

#include "core/base/result.h"
#include "core/link/link_uri.h"
#include "core/thunderbots/sim/radio_sim.h"

namespace kickstand::thunderbots::sim {

/// Which robots there are and how good the radio is. The defaults are sixteen robots that look alive, each
/// with another battery, and a radio without a fault at its true pace.
struct ThunderbotsSimOptions {
    std::uint16_t robots = 0xFFFF;  ///< Bit n: there is a robot n.
    RadioWeather weather;
    std::uint64_t seed = 1;  ///< Of all that happens by chance.
    RadioPace pace = RadioPace::True;
    std::optional<std::uint8_t> cableRobot;  ///< Not a dongle, but this robot on a cable.
    bool noise = true;                       ///< Whether the robots' converters are noisy.
    wire::Channels dongleChannels;           ///< Stored in the dongle.
};

/// The options of a `sim:thunderbots` URI: `robots=0-3,7`, `loss=0.02`, `duplicate=0.01`, `delay_ms=5`,
/// `seed=1`, `radio=true|ideal`, `noise=on|off`, or `cable=3` in the place of `robots`. Errors: UnknownName
/// for another option, OutOfRange with the bounds, BadArgument with what was given. Any thread.
Result<ThunderbotsSimOptions> parseSimOptions(const LinkUri& uri);

}  // namespace kickstand::thunderbots::sim
