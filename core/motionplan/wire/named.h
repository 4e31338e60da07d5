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

namespace kickstand::motionplan::wire {

/// A telegram as the command line names it, with its fields in order.
struct NamedSpec {
    std::string name;  ///< "motionplan.telegram.create".
    std::vector<std::string> fields;
};

/// One field of a telegram that was decoded by name, ready for a person or for JSON.
struct NamedField {
    std::string name;
    std::int64_t value = 0;  ///< The raw number; for bytes, how many there are.
    bool isBytes = false;
    std::vector<std::uint8_t> bytes;
    std::optional<double> physical;  ///< The value in `unit`, where the field has one.
    std::string unit;
    std::string label;        ///< What the value means ("mailbox-empty", "forward 25, turn left 84").
    std::string description;  ///< What the field means, in English.
};

/// A field's name and its value as text: a decimal or 0x number, a label, hex for bytes; movements also as
/// people write them ("forward 25, turn left 84").
using NamedText = std::pair<std::string, std::string>;

/// Every telegram there is a name for: `motionplan.telegram.` with the message that it writes ("create", …,
/// or "write" for any other), "read", "write-reply" and "read-reply". Any thread.
const std::vector<NamedSpec>& namedTelegrams();

/// Writes the telegram of that name; length, type, command, size and terminator write themselves. A field
/// that is not given is zero, but for `box`, which is the message's own. Errors: UnknownName for the telegram
/// or a field, with what there is in `detail`; BadArgument for a field that is missing, given twice, or with
/// text that is no value; OutOfRange with the range. Any thread.
Result<std::vector<std::uint8_t>> encodeNamed(std::string_view name, std::span<const NamedText> fields);

/// Reads a telegram, its length in front, under its name or the family's, "motionplan.telegram"; what a reply
/// or a write carries is listed field by field where it is a message. Errors: UnknownName; Malformed with the
/// field or "length", its range and what there was. Any thread.
Result<std::vector<NamedField>> decodeNamed(std::string_view name, ByteView bytes);

}  // namespace kickstand::motionplan::wire
