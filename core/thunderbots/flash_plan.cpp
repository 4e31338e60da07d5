#include "core/thunderbots/flash_plan.h"

#include <algorithm>
#include <utility>

#include "core/framing/crc16.h"

namespace kickstand::thunderbots {
namespace {

constexpr auto kPage = static_cast<std::uint32_t>(wire::kFlashPageBytes);

bool isErased(ByteView bytes) {
    return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == image::kErased; });
}

/// The bytes of `range` that the image has; what follows them is erased.
ByteView partOf(const std::vector<std::uint8_t>& bytes, const FlashRange& range) {
    const std::size_t begin = std::min<std::size_t>(range.address, bytes.size());
    const std::size_t end = std::min<std::size_t>(range.end(), bytes.size());
    return ByteView(bytes).subspan(begin, end - begin);
}

}  // namespace

FlashPlan::FlashPlan(image::FlashImage image)
    : image_(std::move(image)), signatures_(image::signaturesOf(image_)) {
    const auto count = static_cast<std::uint32_t>((image_.bytes.size() + kPage - 1) / kPage);
    for (std::uint32_t number = 0; number < count; ++number) {
        if (isErased(partOf(image_.bytes, {number * kPage, kPage}))) continue;
        pages_.push_back(static_cast<std::uint16_t>(number));
        extent_ = (number + 1) * kPage;
    }
}

wire::FlashContents FlashPlan::contents() const {
    return target() == image::FlashTarget::Fpga ? wire::FlashContents::FpgaBitstream
                                                : wire::FlashContents::Microcontroller;
}

FlashPage FlashPlan::page(std::uint16_t number) const {
    FlashPage page;
    page.fill(image::kErased);
    std::ranges::copy(partOf(image_.bytes, {number * kPage, kPage}), page.begin());
    return page;
}

std::uint16_t FlashPlan::crc(const FlashRange& range) const {
    const ByteView part = partOf(image_.bytes, range);
    return crc16Fill(image::kErased, range.length - part.size(), crc16(part));
}

bool FlashPlan::blank(const FlashRange& range) const {
    return isErased(partOf(image_.bytes, range));
}

std::vector<FlashRange> crcBlocks(std::uint32_t begin, std::uint32_t end) {
    std::vector<FlashRange> blocks;
    for (std::uint32_t at = begin; at < end; at += wire::kMaxCrcBlock)
        blocks.push_back({at, std::min(wire::kMaxCrcBlock, end - at)});
    return blocks;
}

std::vector<wire::FillPageRequest> planFills(const std::optional<FlashPage>& holds, const FlashPage& wanted) {
    const auto differs = [&](std::size_t at) { return !holds || (*holds)[at] != wanted[at]; };
    std::vector<wire::FillPageRequest> fills;
    // Each message begins at the first byte that is still wrong and reaches as far as it can: no other choice
    // of as many messages covers more.
    for (std::size_t at = 0; at < wanted.size();) {
        if (!differs(at)) {
            ++at;
            continue;
        }
        std::size_t end = std::min(at + wire::kMaxFillBytes, wanted.size());
        const std::size_t next = end;
        while (!differs(end - 1))
            --end;
        wire::FillPageRequest fill;
        fill.offset = static_cast<std::uint8_t>(at);
        fill.data.append(ByteView(wanted).subspan(at, end - at));
        fills.push_back(fill);
        at = next;
    }
    return fills;
}

}  // namespace kickstand::thunderbots
