#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/coach/wire/message.h"

namespace kickstand::coach::wire {

/// The names under which whole frames are read and written: in API mode 1, and in API mode 2.
inline constexpr std::string_view kFrameName = "coach.frame";
inline constexpr std::string_view kEscapedFrameName = "coach.frame-escaped";

/// One field of a frame, ready for a person or for JSON.
struct NamedField {
    std::string name;
    std::int64_t value = 0;
    std::string label;               ///< The name of the value, where it has one.
    std::optional<double> physical;  ///< The value in `unit`, where it has one.
    std::string unit;
    std::string description;
};

/// Takes a frame on the serial line apart: its kind, its header's fields, and what its message says. Errors:
/// UnknownName for a name that is neither of the two; Malformed for bytes that are not exactly one whole
/// frame of this protocol, with what is wrong. Any thread.
Result<std::vector<NamedField>> decodeNamedFrame(std::string_view name, ByteView bytes);

/// Puts a frame together. `kind` is tx, rx or tx-status (tx when it is left out), `message` one of the
/// messages' names; what else is left out is zero, and the destination of a broadcast message 0xFFFF. Errors:
/// UnknownName, BadArgument, OutOfRange. Any thread.
Result<std::vector<std::uint8_t>> encodeNamedFrame(
    std::string_view name, const std::vector<std::pair<std::string, std::string>>& fields);

/// Every name of a field that a frame can have, in their order. Any thread.
std::vector<std::string> namedFrameFields();

}  // namespace kickstand::coach::wire
