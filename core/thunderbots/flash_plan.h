#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/thunderbots/image/flash_image.h"
#include "core/thunderbots/wire/firmware.h"

namespace kickstand::thunderbots {

/// A page of flash, and what the robot's page buffer holds.
using FlashPage = std::array<std::uint8_t, wire::kFlashPageBytes>;

/// A piece of flash.
struct FlashRange {
    std::uint32_t address = 0;
    std::uint32_t length = 0;
    std::uint32_t end() const { return address + length; }
    friend bool operator==(const FlashRange&, const FlashRange&) = default;
};

/// How an image gets into a robot's flash (protocol 4.7, 6.7): which pages are sent, and what every piece of
/// flash is to be afterwards. Immutable once made, so that threads may share it.
class FlashPlan {
  public:
    /// `image` is as image::forTarget() gave it. Takes some milliseconds. Any thread.
    explicit FlashPlan(image::FlashImage image);

    const image::FlashImage& image() const { return image_; }
    image::FlashTarget target() const { return image_.target; }
    /// What the flash contents are set to once the image is there (protocol 4.8).
    wire::FlashContents contents() const;
    /// The pages that are not blank, ascending: the others are never sent.
    const std::vector<std::uint16_t>& pages() const { return pages_; }
    /// A page, padded with 0xFF; blank past the image's end.
    FlashPage page(std::uint16_t number) const;
    /// Bytes from address 0 to the end of the last page that is sent.
    std::uint32_t extent() const { return extent_; }
    /// The CRC of a piece of flash that holds the image and nothing else; it lies within the flash.
    std::uint16_t crc(const FlashRange& range) const;
    /// Whether a piece of flash that holds the image is blank there.
    bool blank(const FlashRange& range) const;
    /// What the robot answers to Read Build Signatures once it has the image.
    const image::ImageSignatures& signatures() const { return signatures_; }

  private:
    image::FlashImage image_;
    std::vector<std::uint16_t> pages_;
    std::uint32_t extent_ = 0;
    image::ImageSignatures signatures_;
};

/// A plan that is shared between a window, the engine and the robots it is for.
using SharedFlashPlan = std::shared_ptr<const FlashPlan>;

/// The longest pieces from `begin` to `end` that a robot computes a CRC of at once. Any thread.
std::vector<FlashRange> crcBlocks(std::uint32_t begin, std::uint32_t end);

/// The fewest messages that make the page buffer hold `wanted`, given what it holds now (none: nobody knows).
/// Bytes that are right already are only sent where they lie between two that are not, within one message.
/// Any thread.
std::vector<wire::FillPageRequest> planFills(const std::optional<FlashPage>& holds, const FlashPage& wanted);

}  // namespace kickstand::thunderbots
