#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/bytes.h"
#include "core/thunderbots/image/image_error.h"

namespace kickstand::thunderbots::image {

/// The longest file that is read: a whole flash as Intel HEX, with room for short records.
inline constexpr std::size_t kLargestFile = 8UL * 1024 * 1024;

/// Which format a file has: by the ending of its name where that says it (.bin, .bit, .hex, .ihx, .mcs), else
/// by how it begins. Any thread.
ImageFormat formatOf(std::string_view fileName, ByteView contents);

/// Reads a firmware file of any format, and guesses which target it is for; the guess is the image's target
/// until forTarget() settles it. Errors: every fault but LooksLikeOther. Any thread.
ImageResult<FlashImage> readImage(std::string_view fileName, ByteView contents);

/// The image as it is to be sent to this target. A microcontroller's has nothing from 0x1F000 to 0x1FFFF:
/// what the file has there moves to `skipped` (protocol 6.7). Errors: LooksLikeOther, PastEnd, Empty. Any
/// thread.
ImageResult<FlashImage> forTarget(FlashImage image, FlashTarget target);

}  // namespace kickstand::thunderbots::image
