#include "core/thunderbots/image/image_builder.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kickstand::thunderbots::image {
namespace {

tl::unexpected<ImageError> refuse(ImageFault fault, std::uint32_t address, std::uint32_t line) {
    ImageError error;
    error.fault = fault;
    error.address = address;
    error.line = line;
    error.most = kFlashBytes - 1;
    error.target = FlashTarget::Fpga;
    return tl::unexpected(error);
}

}  // namespace

ImageResult<void> ImageBuilder::add(std::uint32_t address, ByteView piece, std::uint32_t line) {
    if (piece.empty()) return {};
    if (address >= kFlashBytes) return refuse(ImageFault::PastEnd, address, line);
    if (piece.size() > kFlashBytes - address) return refuse(ImageFault::PastEnd, kFlashBytes, line);
    const auto end = static_cast<std::uint32_t>(address + piece.size());

    const auto after = ranges_.upper_bound(address);
    const auto before = after == ranges_.begin() ? ranges_.end() : std::prev(after);
    if (before != ranges_.end() && before->second.end > address)
        return refuse(ImageFault::Overlap, address, line);
    if (after != ranges_.end() && after->second.begin < end)
        return refuse(ImageFault::Overlap, after->second.begin, line);

    if (bytes_.size() < end) bytes_.resize(end, kErased);
    std::ranges::copy(piece, bytes_.begin() + address);
    auto grown = before;
    if (before != ranges_.end() && before->second.end == address) {
        before->second.end = end;
    } else {
        grown = ranges_.emplace_hint(after, address, DataRange{address, end, line});
    }
    if (after != ranges_.end() && after->second.begin == end) {
        grown->second.end = after->second.end;
        ranges_.erase(after);
    }
    return {};
}

ImageData ImageBuilder::take() {
    ImageData data;
    data.bytes = std::exchange(bytes_, {});
    data.ranges.reserve(ranges_.size());
    for (const auto& [begin, range] : ranges_)
        data.ranges.push_back(range);
    ranges_.clear();
    return data;
}

}  // namespace kickstand::thunderbots::image
