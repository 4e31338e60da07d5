#pragma once

#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/thunderbots/wire/firmware.h"

namespace kickstand::thunderbots {

/// What is known of how long a robot keeps the parameters that it has (protocol 4.8). Reading shows only the
/// volatile copy, so that a commit is proven by a reading after a reboot and by nothing else.
enum class ParameterStanding : std::uint8_t {
    Unread,     ///< They have not been read.
    AsRead,     ///< As the robot had them when it was read; nothing has been changed since.
    Applied,    ///< Changed, and not committed: they live until its next reboot.
    Committed,  ///< Committed, unproven until the next reboot.
    Rebooted,   ///< Committed, and rebooted since: the next reading proves it, or proves it wrong.
    Proven,     ///< Read after a reboot, and just what was committed.
    Disproven,  ///< Read after a reboot, and not what was committed.
};

/// One robot's parameters, as far as they are known.
struct ParameterState {
    ParameterStanding standing = ParameterStanding::Unread;
    std::optional<wire::OperationalParameters> robot;  ///< The volatile copy, when last read or set.
    TimePoint readAt{};
    /// What was committed last and is to be found again after a reboot.
    std::optional<wire::OperationalParameters> committed;
    /// Build signatures, when last read (protocol 4.7).
    std::optional<wire::ReadSignaturesResponse> signatures;
    TimePoint signaturesAt{};
    int movedTo = -1;  ///< It was told to reboot with this number, and is to come back under it.

    friend bool operator==(const ParameterState&, const ParameterState&) = default;
};

/// "unread", "as-read", "applied", …: stable names for JSON. Any thread.
const char* name(ParameterStanding standing);

}  // namespace kickstand::thunderbots
