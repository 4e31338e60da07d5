#pragma once

#include "core/base/bytes.h"
#include "core/thunderbots/image/image_builder.h"

namespace kickstand::thunderbots::image {

/// Reads an Intel HEX file: record types 00 to 05, digits in either case, lines ended by LF, CR or both,
/// empty lines anywhere. Start addresses (03, 05) are checked and mean nothing to a robot. Errors: Junk,
/// BadLength, BadChecksum, UnknownType, Overlap, PastEnd (of the flash), MissingEnd, AfterEnd, each with its
/// line. Any thread.
ImageResult<ImageData> readIntelHex(ByteView file);

}  // namespace kickstand::thunderbots::image
