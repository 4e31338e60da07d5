#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace kickstand {

/// "80 7f e0": lower case, two digits a byte, one space between. Any thread.
std::string toHex(ByteView bytes);

/// Reads hex digits in either case; spaces, tabs, colons and a "0x" before a byte are allowed between bytes.
/// Errors: Malformed with the offending text and its place (`got`, counted from 0). Any thread.
Result<std::vector<std::uint8_t>> parseHex(std::string_view text);

}  // namespace kickstand
