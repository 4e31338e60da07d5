#include "core/thunderbots/wire/wire_error.h"

#include <utility>

namespace kickstand::thunderbots::wire {

const char* name(WireFault fault) noexcept {
    switch (fault) {
        case WireFault::TooShort:
            return "too-short";
        case WireFault::TooLong:
            return "too-long";
        case WireFault::BadLength:
            return "bad-length";
        case WireFault::BadValue:
            return "bad-value";
        case WireFault::UnknownKind:
            return "unknown-kind";
        case WireFault::OutOfRange:
            return "out-of-range";
    }
    return "unknown-fault";
}

Error toError(const WireError& error, std::string subject) {
    Error result;
    result.code = error.fault == WireFault::OutOfRange ? Errc::OutOfRange : Errc::Malformed;
    result.subject = std::move(subject);
    if (!result.subject.empty()) result.subject += ' ';
    result.subject += error.field;
    result.lowest = error.lowest;
    result.highest = error.highest;
    result.got = error.got;
    result.detail = name(error.fault);
    return result;
}

}  // namespace kickstand::thunderbots::wire
