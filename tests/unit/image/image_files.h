#pragma once

#include <string>
#include <vector>

#include "core/thunderbots/image/image_file.h"

namespace kickstand::thunderbots::image::testing {

using Bytes = std::vector<std::uint8_t>;

/// A file of tests/data/images; empty, and a failed test, where there is none.
Bytes readData(const std::string& name);
/// readImage() of such a file.
ImageResult<FlashImage> imageOf(const std::string& name);

Bytes bytesOf(const std::string& text);
/// An Intel HEX file with this image's data in records of `size` bytes, written by code that the reader does
/// not share.
std::string hexOf(const FlashImage& image, std::size_t size);
/// A record with its checksum, without a line's end.
std::string hexRecord(int type, unsigned offset, const Bytes& data);

}  // namespace kickstand::thunderbots::image::testing
