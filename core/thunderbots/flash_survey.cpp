#include "core/thunderbots/flash_survey.h"

#include <algorithm>

#include "core/framing/crc16.h"

namespace kickstand::thunderbots {
namespace {

constexpr auto kPage = static_cast<std::uint32_t>(wire::kFlashPageBytes);

/// The first half of a piece, in whole pages.
std::uint32_t halfOf(const FlashRange& range) {
    return (range.length / kPage + 1) / 2 * kPage;
}

}  // namespace

FlashSurvey::FlashSurvey(const FlashPlan& plan, std::uint32_t end) : plan_(&plan) {
    const std::uint32_t extent = std::min(plan.extent(), end);
    open_ = crcBlocks(0, extent);
    const auto rest = crcBlocks(extent, end);
    open_.insert(open_.end(), rest.begin(), rest.end());
    std::ranges::reverse(open_);
}

std::optional<FlashRange> FlashSurvey::next() const {
    if (dirtyAt_ || open_.empty()) return std::nullopt;
    return open_.back();
}

void FlashSurvey::answered(std::uint16_t crc) {
    if (open_.empty()) return;
    const FlashRange range = open_.back();
    open_.pop_back();
    if (crc == plan_->crc(range)) {
        known_ += range.length;
    } else if (crc == crc16Fill(image::kErased, range.length)) {
        known_ += range.length;
        const auto& pages = plan_->pages();
        const auto first = std::ranges::lower_bound(pages, range.address / kPage);
        const auto last = std::ranges::lower_bound(pages, range.end() / kPage);
        missing_.insert(missing_.end(), first, last);
    } else if (range.length <= kPage || plan_->blank(range)) {
        dirtyAt_ = range.address;
    } else {
        const std::uint32_t half = halfOf(range);
        open_.push_back({range.address + half, range.length - half});
        open_.push_back({range.address, half});
    }
}

}  // namespace kickstand::thunderbots
