#include "core/thunderbots/image/image_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/thunderbots/image/intel_hex.h"
#include "core/thunderbots/image/xilinx_bit.h"

namespace kickstand::thunderbots::image {
namespace {

/// A bitstream's synchronisation word comes after a few words of padding; one further in is chance.
constexpr std::size_t kSyncWithin = 256;
using SyncWord = std::array<std::uint8_t, 4>;
/// As the FPGA reads it, and with the bits of each byte turned round, as some tools write flash images.
constexpr std::array<SyncWord, 2> kSyncWords{SyncWord{0xAA, 0x99, 0x55, 0x66},
                                             SyncWord{0x55, 0x99, 0xAA, 0x66}};

ImageError errorOf(ImageFault fault) {
    ImageError error;
    error.fault = fault;
    return error;
}

bool endsWith(std::string_view name, std::string_view ending) {
    return name.size() >= ending.size() &&
           std::ranges::equal(name.substr(name.size() - ending.size()), ending, [](char a, char b) {
               return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + ('a' - 'A')) : a) == b;
           });
}

/// A colon and at least the digits of an empty record.
bool beginsAsHex(ByteView contents) {
    constexpr std::size_t kShortestRecord = 11;
    const auto begin = std::ranges::find_if(
        contents, [](std::uint8_t c) { return c != ' ' && c != '\t' && c != '\r' && c != '\n'; });
    const ByteView rest(begin, contents.end());
    if (rest.size() < kShortestRecord || rest[0] != ':') return false;
    return std::ranges::all_of(rest.subspan(1, kShortestRecord - 1), [](std::uint8_t c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    });
}

bool hasSyncWord(const std::vector<std::uint8_t>& bytes) {
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kSyncWithin));
    return std::ranges::any_of(kSyncWords, [&](const SyncWord& word) {
        return std::search(bytes.begin(), end, word.begin(), word.end()) != end;
    });
}

/// The microcontroller begins with its GOTO: two words, whose highest bits are 1110 1111 and 1111.
bool hasResetVector(const std::vector<std::uint8_t>& bytes) {
    return bytes.size() >= 4 && bytes[1] == 0xEF && (bytes[3] & 0xF0) == 0xF0 && bytes[3] != 0xFF;
}

TargetGuess guess(const FlashImage& image) {
    if (image.format == ImageFormat::XilinxBit) return {FlashTarget::Fpga, GuessReason::BitHeader};
    if (hasSyncWord(image.bytes)) return {FlashTarget::Fpga, GuessReason::SyncWord};
    if (hasResetVector(image.bytes)) return {FlashTarget::Microcontroller, GuessReason::ResetVector};
    if (image.bytes.size() > kMicrocontrollerBytes) return {FlashTarget::Fpga, GuessReason::Size};
    const bool hex = image.format == ImageFormat::IntelHex;
    return {hex ? FlashTarget::Microcontroller : FlashTarget::Fpga, GuessReason::Form};
}

ImageResult<ImageData> readPlain(ByteView contents) {
    ImageBuilder builder;
    if (const auto added = builder.add(0, contents, 0); !added) return tl::unexpected(added.error());
    return builder.take();
}

ImageResult<ImageData> readData(FlashImage& image, ByteView contents) {
    if (image.format == ImageFormat::IntelHex) return readIntelHex(contents);
    if (image.format == ImageFormat::Binary) return readPlain(contents);
    auto bit = readXilinxBit(contents);
    if (!bit) return tl::unexpected(bit.error());
    image.header = std::move(bit->header);
    return readPlain(bit->data);
}

/// Moves what lies from `boundary` on from the image to what is skipped.
void skipFrom(FlashImage& image, std::uint32_t boundary) {
    std::vector<DataRange> kept;
    for (const DataRange& range : image.data) {
        if (range.begin < boundary) kept.push_back({range.begin, std::min(range.end, boundary), range.line});
        if (range.end <= boundary) continue;
        const bool cut = range.begin < boundary;
        image.skipped.push_back({cut ? boundary : range.begin, range.end, cut ? 0 : range.line});
    }
    image.data = std::move(kept);
    image.bytes.resize(image.data.empty() ? 0 : image.data.back().end);
}

}  // namespace

ImageFormat formatOf(std::string_view fileName, ByteView contents) {
    for (const std::string_view ending : {".hex", ".ihx", ".mcs"}) {
        if (endsWith(fileName, ending)) return ImageFormat::IntelHex;
    }
    if (endsWith(fileName, ".bit")) return ImageFormat::XilinxBit;
    if (endsWith(fileName, ".bin")) return ImageFormat::Binary;
    if (beginsAsBit(contents)) return ImageFormat::XilinxBit;
    return beginsAsHex(contents) ? ImageFormat::IntelHex : ImageFormat::Binary;
}

ImageResult<FlashImage> readImage(std::string_view fileName, ByteView contents) {
    if (contents.size() > kLargestFile) {
        ImageError error = errorOf(ImageFault::TooLarge);
        error.got = static_cast<std::uint32_t>(std::min<std::size_t>(contents.size(), UINT32_MAX));
        error.most = kLargestFile;
        return tl::unexpected(error);
    }
    FlashImage image;
    image.format = formatOf(fileName, contents);
    auto data = readData(image, contents);
    if (!data) return tl::unexpected(data.error());
    if (data->ranges.empty()) return tl::unexpected(errorOf(ImageFault::Empty));
    image.bytes = std::move(data->bytes);
    image.data = std::move(data->ranges);
    image.guess = guess(image);
    image.target = image.guess.target;
    return image;
}

ImageResult<FlashImage> forTarget(FlashImage image, FlashTarget target) {
    if (image.guess.certain() && image.guess.target != target) {
        ImageError error = errorOf(ImageFault::LooksLikeOther);
        error.target = target;
        error.reason = image.guess.reason;
        return tl::unexpected(error);
    }
    image.target = target;
    if (target == FlashTarget::Fpga) return image;
    for (const DataRange& range : image.data) {
        if (range.end <= kMicrocontrollerBytes) continue;
        ImageError error = errorOf(ImageFault::PastEnd);
        error.target = target;
        error.address = std::max(range.begin, kMicrocontrollerBytes);
        error.line = range.begin >= kMicrocontrollerBytes ? range.line : 0;
        error.most = kMicrocontrollerBytes - 1;
        return tl::unexpected(error);
    }
    skipFrom(image, kMicrocontrollerCopiedBytes);
    if (image.data.empty()) return tl::unexpected(errorOf(ImageFault::Empty));
    return image;
}

}  // namespace kickstand::thunderbots::image
