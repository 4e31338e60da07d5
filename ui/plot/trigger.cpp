#include "ui/plot/trigger.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace kickstand::ui {

namespace {

constexpr std::size_t kChunk = 256;

}  // namespace

Trigger::Trigger(const TimeSeries& series, Edge edge, float level)
    : series_(&series), edge_(edge), level_(level), next_(series.total()) {
    std::array<Sample, 1> held;
    if (next_ > 0 && series.copy(next_ - 1, held).count == 1) before_ = held[0].value;
}

std::optional<TimePoint> Trigger::check() {
    std::array<Sample, kChunk> samples;
    for (;;) {
        const RingCopy copied = series_->copy(next_, samples);
        next_ = copied.next;
        if (copied.lost > 0) before_ = kNoValue;
        for (const Sample& sample : std::span(samples).first(copied.count)) {
            if (crosses(sample.value)) return sample.time;
        }
        if (copied.count < samples.size()) return std::nullopt;
    }
}

bool Trigger::crosses(float value) {
    const float before = std::exchange(before_, value);
    // Both comparisons are false for a gap on either side.
    return edge_ == Edge::Rising ? before < level_ && value >= level_ : before > level_ && value <= level_;
}

}  // namespace kickstand::ui
