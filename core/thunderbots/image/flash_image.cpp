#include "core/thunderbots/image/flash_image.h"

#include <algorithm>

#include "core/framing/crc16.h"

namespace kickstand::thunderbots::image {
namespace {

/// The CRC of the first `length` bytes of flash that holds nothing but the image.
std::uint16_t paddedCrc(const std::vector<std::uint8_t>& bytes, std::size_t length) {
    const std::size_t own = std::min(bytes.size(), length);
    return crc16Fill(kErased, length - own, crc16({bytes.data(), own}));
}

}  // namespace

std::uint32_t FlashImage::dataBytes() const {
    std::uint32_t sum = 0;
    for (const DataRange& range : data)
        sum += range.size();
    return sum;
}

ImageSignatures signaturesOf(const FlashImage& image) {
    return {paddedCrc(image.bytes, kMicrocontrollerCopiedBytes), paddedCrc(image.bytes, kFlashBytes)};
}

const char* name(FlashTarget target) {
    return target == FlashTarget::Fpga ? "fpga" : "microcontroller";
}

const char* name(ImageFormat format) {
    switch (format) {
        case ImageFormat::IntelHex:
            return "intel-hex";
        case ImageFormat::Binary:
            return "binary";
        case ImageFormat::XilinxBit:
            return "xilinx-bit";
    }
    return "unknown";
}

const char* name(GuessReason reason) {
    switch (reason) {
        case GuessReason::BitHeader:
            return "bit-header";
        case GuessReason::SyncWord:
            return "sync-word";
        case GuessReason::ResetVector:
            return "reset-vector";
        case GuessReason::Size:
            return "size";
        case GuessReason::Form:
            return "form";
    }
    return "unknown";
}

}  // namespace kickstand::thunderbots::image
