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

namespace kickstand::thunderbots::wire {

/// One field of a message that was decoded by name, ready for a person or for JSON.
struct DecodedField {
    std::string name;        ///< As in the table; "2.robot" for the second message of a list.
    std::int64_t value = 0;  ///< The raw number; for bytes, how many there are.
    bool isBytes = false;
    std::vector<std::uint8_t> bytes;
    std::optional<double> physical;  ///< The value in `unit`, where the field has one.
    std::string unit;
    std::string label;        ///< The name of the value, where it has one ("hall").
    std::string description;  ///< What the field means, in English.
};

/// A field's name and its value as text: a decimal or 0x number, "true"/"false" for a flag, a label where the
/// field has labels, hex for bytes.
using FieldText = std::pair<std::string, std::string>;

/// Writes the message of that name ("thunderbots.drive"; fields.h lists them all). A field that is not given
/// is zero; one that may not be zero must be given, only opcodes and lengths write themselves. A list takes
/// its fields as decodeMessage() names them. Errors: UnknownName for the message or a field, with what there
/// is in `detail`; BadArgument for a field missing, given twice, or with text that is no value; OutOfRange
/// with the range. Any thread.
Result<std::vector<std::uint8_t>> encodeMessage(std::string_view name, std::span<const FieldText> fields);

/// Reads the message of that name, or of that family. Reserved bits are listed only where they are not zero.
/// Errors: UnknownName; Malformed with the field or "length", its range and what there was. Any thread.
Result<std::vector<DecodedField>> decodeMessage(std::string_view name, ByteView bytes);

}  // namespace kickstand::thunderbots::wire
