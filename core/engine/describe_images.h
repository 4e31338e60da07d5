#pragma once

#include "core/engine/describe.h"
#include "core/thunderbots/image/image_error.h"

namespace kickstand {

// The words for firmware files. Any thread once the application object exists.

/// Why a file gives no image, and what to do about it.
Description describe(const thunderbots::image::ImageError& error);
/// "microcontroller", "FPGA".
QString describe(thunderbots::image::FlashTarget target);
/// "Intel HEX", "binary", "Xilinx .bit".
QString describe(thunderbots::image::ImageFormat format);
/// Why an image is taken to be for its target, to follow "FPGA: ".
QString describe(thunderbots::image::GuessReason reason);
/// "0x1f000"; six digits where five do not do.
QString addressText(std::uint32_t address);

}  // namespace kickstand
