#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace kickstand::smartdevice::wire {

/// The names under which whole frames are read and written: in the current dialect, and in Hibike.
inline constexpr std::string_view kFrameName = "smartdevice.frame";
inline constexpr std::string_view kHibikeFrameName = "smartdevice.frame-hibike";

/// One field of a frame that was decoded by name, ready for a person or for JSON.
struct NamedField {
    std::string name;
    std::int64_t value = 0;  ///< The raw number; for bytes, how many there are.
    bool isBytes = false;
    std::vector<std::uint8_t> bytes;
    std::optional<double> physical;  ///< The value in `unit`, where the field has one.
    std::string unit;
    std::string label;        ///< What the value means ("ping", "parameters 0, 2").
    std::string description;  ///< What the field means, in English.
};

/// A field's name and its value as text.
using NamedText = std::pair<std::string, std::string>;

/// Takes one whole frame apart: its message, and the fields of that. Errors: UnknownName for a name that is
/// neither of the two; Malformed for bytes that are not exactly one frame, with what is wrong. Any thread.
Result<std::vector<NamedField>> decodeNamedFrame(std::string_view name, ByteView bytes);

/// Puts a frame together: `message` is one of the messages' names, the rest are that message's fields. What
/// is left out is zero. Numbers are decimal or 0x; `uid` as toText(Uid) has it; `values` hex. Errors:
/// UnknownName for the frame, the message or a field; BadArgument; OutOfRange. Any thread.
Result<std::vector<std::uint8_t>> encodeNamedFrame(std::string_view name, std::span<const NamedText> fields);

/// Every name of a field that a frame can have, in their order. Any thread.
std::vector<std::string> namedFrameFields();

}  // namespace kickstand::smartdevice::wire
