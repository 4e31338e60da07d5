#pragma once

#include "core/link/usbip/usbip_wire.h"
#include "tests/fuzz/fuzz.h"

namespace kickstand::fuzz {

/// Whether a message was found, after checking what holds for every answer of a parser.
inline bool parsed(ByteView input, const usbip::Parse& parse) {
    switch (parse.status) {
        case usbip::Parse::Status::Complete:
            require(parse.bytes > 0 && parse.bytes <= input.size(), "a message lies in what was given");
            return true;
        case usbip::Parse::Status::MoreNeeded:
            require(parse.bytes > input.size(), "more is asked for than was given");
            return false;
        case usbip::Parse::Status::Malformed:
            require(*parse.why != '\0', "a refusal says why");
            return false;
    }
    return false;
}

}  // namespace kickstand::fuzz
