#pragma once

#include <cstdint>
#include <optional>

#include "core/telemetry/time_series.h"

namespace kickstand::ui {

enum class Edge { Rising, Falling };

/// Waits for a quantity to cross a level. Reads the series in place, each sample once.
class Trigger {
  public:
    /// Begins at what the series holds now: only what comes later counts.
    Trigger(const TimeSeries& series, Edge edge, float level);

    /// When the level was first crossed since the last call; nothing while it was not. Coming out of a gap on
    /// the far side is no crossing: nobody saw it. Call it often: samples that were overwritten unseen are
    /// taken for a gap.
    std::optional<TimePoint> check();

  private:
    bool crosses(float value);

    const TimeSeries* series_;
    Edge edge_;
    float level_;
    std::uint64_t next_ = 0;
    float before_ = kNoValue;
};

}  // namespace kickstand::ui
