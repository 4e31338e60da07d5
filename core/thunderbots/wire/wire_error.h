#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include "core/base/error.h"

namespace kickstand::thunderbots::wire {

/// What is wrong with bytes that were read, or with values that were to be written.
enum class WireFault : std::uint8_t {
    TooShort,     ///< Fewer bytes than the message has.
    TooLong,      ///< More bytes than the message has, or than fit.
    BadLength,    ///< A length that contradicts the message around it or its kind.
    BadValue,     ///< Bytes hold a value that the protocol does not know.
    UnknownKind,  ///< A pipe, opcode or class that does not exist, or not in this direction.
    OutOfRange,   ///< A value to be written lies outside its field's range.
};

/// An error of a codec: plain facts, no allocation. `lowest` to `highest` is what would have been accepted,
/// in the unit of the field; for the length faults that is bytes.
struct WireError {
    WireFault fault = WireFault::BadValue;
    const char* field = "";  ///< A name from the field tables, or "length". A string literal.
    std::int32_t lowest = 0;
    std::int32_t highest = 0;
    std::int32_t got = 0;
};

/// What encoders and decoders give: the value, or why there is none.
template <class T>
using WireResult = tl::expected<T, WireError>;

/// The stable, lower-case, hyphenated name of a fault ("too-short"). Any thread.
const char* name(WireFault fault) noexcept;

/// The same facts for the world outside the codecs: OutOfRange stays, everything else is Malformed; `subject`
/// is what was encoded or decoded, and the field's name is put behind it. Allocates. Any thread.
Error toError(const WireError& error, std::string subject);

}  // namespace kickstand::thunderbots::wire
