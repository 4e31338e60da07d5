#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include "core/base/error.h"
#include "core/thunderbots/image/flash_image.h"

namespace kickstand::thunderbots::image {

/// Why a file gives no image. The comment says what the error's numbers mean for it.
enum class ImageFault : std::uint8_t {
    TooLarge,     ///< got: bytes of the file, most: how many are read.
    Empty,        ///< No data in it, or none that the target takes.
    Junk,         ///< A line that is no record. got: the place in the line, from 1.
    BadLength,    ///< A record or bitstream that is shorter or longer than it says, or than its type is. got
                  ///< and most: digits of the line, without a line bytes.
    BadChecksum,  ///< got: the checksum that is there, most: the one that the bytes give.
    UnknownType,  ///< got: the record's type.
    Overlap,      ///< Data for an address that has some already. address.
    MissingEnd,   ///< The end record is missing: the file has been cut off.
    AfterEnd,     ///< Something stands behind the end record.
    PastEnd,      ///< Data at an address past the target's end. address, most: the target's last address.
    BadHeader,    ///< The header of a .bit file cannot be read. got: the byte where, from 0.
    LooksLikeOther  ///< It is plainly for the other target. reason: by what.
};

/// What is wrong with a file: plain facts, no allocation.
struct ImageError {
    ImageFault fault = ImageFault::Junk;
    std::uint32_t line = 0;     ///< From 1; 0 where it is not about a line.
    std::uint32_t address = 0;  ///< As ImageFault says.
    std::uint32_t got = 0;
    std::uint32_t most = 0;
    FlashTarget target = FlashTarget::Microcontroller;  ///< PastEnd, LooksLikeOther: what was asked for.
    GuessReason reason = GuessReason::Form;

    friend bool operator==(const ImageError&, const ImageError&) = default;
};

/// What readers of files give: the value, or why there is none.
template <class T>
using ImageResult = tl::expected<T, ImageError>;

/// "bad-checksum", …: stable names for JSON. Any thread.
const char* name(ImageFault fault);

/// The same facts for where an Error is wanted: Malformed, its detail being the fault's name and its line or
/// address. Allocates. Any thread.
Error toError(const ImageError& error, std::string file);

}  // namespace kickstand::thunderbots::image
