#pragma once

#include "core/base/bytes.h"
#include "core/thunderbots/image/image_error.h"

namespace kickstand::thunderbots::image {

/// A .bit file taken apart.
struct BitFile {
    BitHeader header;
    ByteView data;  ///< The bitstream: a part of the bytes that were read.
};

/// Whether bytes begin as every .bit file does. Any thread.
bool beginsAsBit(ByteView file);

/// Reads a Xilinx .bit file: its header's fields a (design), b (part), c (date), d (time), then e, the
/// bitstream, to the end of the file. Errors: BadHeader with the byte where it stops making sense; BadLength
/// where the bitstream is not as long as the header says. Any thread.
ImageResult<BitFile> readXilinxBit(ByteView file);

}  // namespace kickstand::thunderbots::image
