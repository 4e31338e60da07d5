#pragma once

#include <optional>
#include <vector>

#include "core/thunderbots/flash_plan.h"

namespace kickstand::thunderbots {

/// Finds out by block CRCs how much of an image a flash holds: in the largest blocks, and where one is not as
/// it is to be, in halves of it down to the page (protocol 4.7). Pure: whoever uses it asks the robot.
class FlashSurvey {
  public:
    /// Looks at the flash from address 0 to `end`. `plan` outlives it.
    FlashSurvey(const FlashPlan& plan, std::uint32_t end);

    /// The piece whose CRC is to be known next; none when all is known, or when there is something that only
    /// an erase mends.
    std::optional<FlashRange> next() const;
    /// The CRC of that piece.
    void answered(std::uint16_t crc);

    /// The first address of a piece that is neither blank nor as it is to be.
    const std::optional<std::uint32_t>& dirtyAt() const { return dirtyAt_; }
    /// Pages of the image that are still blank, ascending.
    const std::vector<std::uint16_t>& missing() const { return missing_; }
    /// Bytes of which all is known.
    std::uint32_t known_B() const { return known_; }

  private:
    const FlashPlan* plan_;
    std::vector<FlashRange> open_;  ///< What is not known, the next one last.
    std::vector<std::uint16_t> missing_;
    std::optional<std::uint32_t> dirtyAt_;
    std::uint32_t known_ = 0;
};

}  // namespace kickstand::thunderbots
