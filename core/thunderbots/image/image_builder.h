#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/base/bytes.h"
#include "core/thunderbots/image/image_error.h"

namespace kickstand::thunderbots::image {

/// The bytes of a file by address, and where it has any.
struct ImageData {
    std::vector<std::uint8_t> bytes;
    std::vector<DataRange> ranges;
};

/// Collects a file's pieces, in whatever order they come.
class ImageBuilder {
  public:
    /// Puts `piece` at `address`. Errors: PastEnd (of the flash) and Overlap, with the first address that is
    /// wrong.
    ImageResult<void> add(std::uint32_t address, ByteView piece, std::uint32_t line);
    /// All that was added; the builder is empty afterwards.
    ImageData take();

  private:
    std::vector<std::uint8_t> bytes_;
    std::map<std::uint32_t, DataRange> ranges_;  ///< By where they begin.
};

}  // namespace kickstand::thunderbots::image
