#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "core/smartdevice/wire/message.h"
#include "core/smartdevice/wire/value.h"

namespace kickstand::smartdevice {

// What a person, a script or a panel may ask of a session. Plain values; each is answered once. `device` is
// the number that the snapshot gives it. All of them are refused with NotConnected where the device is not
// there now, and with UnknownName where there never was one of that number.

/// Asks for updates of these parameters from now on, also after the device has been away. Answered when the
/// device has said what it grants; TimedOut, though it is asked on for a while. The mask is cut to what can
/// be read.
struct Subscribe {
    static constexpr bool kMovesNothing = true;
    int device = 0;
    wire::ParameterMask parameters = 0;
    std::uint16_t delay_ms = 40;  ///< 0 ends the updates.
    bool told = false;            ///< Each Data is an event of its own, so that none is missed.
};

/// Asks for values once. Answered when all of them have come; BadArgument where nothing of it can be read,
/// TimedOut.
struct ReadValues {
    static constexpr bool kMovesNothing = true;
    int device = 0;
    wire::ParameterMask parameters = 0;
};

/// Sets values. Answered when they have been judged (the snapshot has the verdicts): DeviceRefused where the
/// device left one out. Refused with StopLatched, BadArgument for a parameter that cannot be written or a
/// value of another type, OutOfRange past the catalogue's bounds.
struct WriteValues {
    int device = 0;
    std::vector<std::pair<int, wire::Value>> values;
};

/// Lets a device stop everything; its next write resumes it. Never refused for STOP.
struct DisableDevice {
    static constexpr bool kMovesNothing = true;
    int device = 0;
};

/// Tries every port again at which no device answered, or that could not be opened.
struct SearchAgain {
    static constexpr bool kMovesNothing = true;
};

/// Any of them.
using Command = std::variant<Subscribe, ReadValues, WriteValues, DisableDevice, SearchAgain>;

}  // namespace kickstand::smartdevice
